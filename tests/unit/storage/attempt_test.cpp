// SPDX-License-Identifier: BSD-3-Clause
// Attempts fence each other off, and leave their records as the contract has them.
#include "storage/attempt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <xxhash.h>

#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "base/error.hpp"
#include "storage/checksum.hpp"
#include "storage/records.hpp"
#include "storage/unfinished.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

class Attempts : public ::testing::Test {
 protected:
  TemporaryDirectory directory;
  const std::filesystem::path& run = directory.path();
  FileSystem& files = posix_file_system();

  void make(int number, const std::string& token) {
    std::filesystem::create_directories(run / "attempts" / std::to_string(number));
    set_content(run / "attempts" / std::to_string(number) / "owner", token + "\n");
  }
  template <class Work>
  Exit code_of(const Work& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.code();
    }
    return Exit::finished;
  }
};

TEST_F(Attempts, NumbersCountUpAndTokensDiffer) {
  const Attempt first = Attempt::claim(files, run);
  const Attempt second = Attempt::claim(files, run);
  EXPECT_EQ(first.number(), 1);
  EXPECT_EQ(second.number(), 2);
  EXPECT_NE(first.token(), second.token());
  EXPECT_EQ(content_of(run / "attempts/2/owner"), second.token() + "\n");
}

TEST_F(Attempts, NewerOneLeavesOlderOnesNothingToRename) {
  Attempt::claim(files, run);
  std::filesystem::create_directory(run / "checkpoints");
  std::filesystem::create_directory(run / "snapshots");
  const std::vector<std::string> of_older{"checkpoints/000000000010.h5.a1.tmp", "samples.csv.a1.tmp",
                                          "snapshots/000000000010.h5.a1.tmp", "snapshots/cells.xdmf.a1.tmp"};
  const std::vector<std::string> of_others{"samples.csv.a3.tmp", "notes.tmp", "notes.a1"};
  for (const std::string& name : of_older) set_content(run / name, "half");
  for (const std::string& name : of_others) set_content(run / name, "x");
  Attempt::claim(files, run);
  for (const std::string& name : of_older) EXPECT_FALSE(std::filesystem::exists(run / name)) << name;
  for (const std::string& name : of_others) EXPECT_TRUE(std::filesystem::exists(run / name)) << name;
}

TEST_F(Attempts, TakenOverBetweenFenceAndRenameNothingIsRenamed) {
  Attempt::claim(files, run);
  const auto passes_and_is_taken_over = [&] { Attempt::claim(files, run); };
  EXPECT_EQ(code_of([&] { write_fenced(files, run / "progress.json", "{}", 1, passes_and_is_taken_over); }), Exit::io);
  EXPECT_FALSE(std::filesystem::exists(run / "progress.json"));
}

TEST_F(Attempts, NewerOneFencesTheOlderOff) {
  const Attempt first = Attempt::claim(files, run);
  EXPECT_TRUE(first.is_newest());
  first.fence();
  const Attempt second = Attempt::claim(files, run);
  EXPECT_FALSE(first.is_newest());
  EXPECT_TRUE(second.is_newest());
  EXPECT_EQ(code_of([&] { first.fence(); }), Exit::superseded);
}

TEST_F(Attempts, FolderWithoutAnOwnerAlreadyFences) {
  const Attempt first = Attempt::claim(files, run);
  std::filesystem::create_directory(run / "attempts/2");
  EXPECT_FALSE(first.is_newest());
}

TEST_F(Attempts, AreNumbersNotStrings) {
  for (int k = 1; k <= 10; ++k) make(k, "t");
  EXPECT_EQ(Attempt::claim(files, run).number(), 11);
  std::filesystem::create_directory(run / "attempts/old");
  std::filesystem::create_directory(run / "attempts/099");
  EXPECT_EQ(newest_attempt(files, run), 11);
}

TEST_F(Attempts, ChangedTokenFences) {
  const Attempt first = Attempt::claim(files, run);
  make(1, "somebody else's");
  EXPECT_EQ(code_of([&] { first.fence(); }), Exit::superseded);
}

TEST_F(Attempts, JoinTakesTheManagersAttempt) {
  make(1, "aa");
  make(2, "9f2c");
  const Attempt attempt = Attempt::join(files, run, 2, "9f2c");
  EXPECT_EQ(attempt.directory(), run / "attempts/2");
  EXPECT_TRUE(attempt.is_newest());
  EXPECT_EQ(code_of([&] { Attempt::join(files, run, 2, "0000"); }), Exit::superseded);
  EXPECT_EQ(code_of([&] { Attempt::join(files, run, 1, "aa"); }), Exit::superseded);
  EXPECT_EQ(code_of([&] { Attempt::join(files, run, 3, "aa"); }), Exit::usage);
}

TEST_F(Attempts, ClaimedAtOnceAllGetTheirOwn) {
  constexpr int claimants = 8;
  std::vector<int> numbers(claimants);
  std::vector<std::thread> threads;
  for (int i = 0; i < claimants; ++i) {
    threads.emplace_back([&, i] { numbers[static_cast<std::size_t>(i)] = Attempt::claim(files, run).number(); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::set<int>(numbers.begin(), numbers.end()).size(), static_cast<std::size_t>(claimants));
}

TEST_F(Attempts, StartedRecordTellsTheProcess) {
  const Attempt attempt = Attempt::claim(files, run);
  write_started(files, attempt, this_process(files), 2);
  const Json record = Json::parse(content_of(run / "attempts/1/started.json"));
  EXPECT_EQ(record.at("contract"), 1);
  EXPECT_EQ(record.at("pid"), ::getpid());
  EXPECT_EQ(record.at("ranks"), 2);
  std::string boot = content_of("/proc/sys/kernel/random/boot_id");
  boot.pop_back();
  EXPECT_EQ(record.at("boot_id"), boot);
  // Field 22, counted here on a stat line whose program name has no spaces.
  std::istringstream stat(content_of("/proc/self/stat"));
  std::string field;
  for (int i = 0; i < 22; ++i) stat >> field;
  EXPECT_EQ(std::to_string(record.at("start_ticks").get<std::uint64_t>()), field);
}

TEST_F(Attempts, ExitRecordHasTheContractsEntries) {
  const Attempt attempt = Attempt::claim(files, run);
  ExitRecord record;
  record.code = Exit::stopped;
  record.reason = "stop requested by signal \"USR2\"";
  record.step = 12000;
  record.resumed_from = "checkpoints/000000008000.h5";
  record.rejected_checkpoints = {{"000000010000.h5", "damaged"}};
  write_exit_record(files, attempt.directory(), record);
  const Json written = Json::parse(content_of(run / "attempts/1/exit.json"));
  std::set<std::string> names;
  for (const auto& [name, value] : written.items()) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"contract", "code", "reason", "step", "end_step", "start_step", "wall_s",
                                          "core_s", "ranks", "mlups", "host", "resumed_from", "rejected_checkpoints",
                                          "version", "git", "finished_unix_s", "check"}));
  EXPECT_EQ(written.at("code"), 75);
  EXPECT_EQ(written.at("reason"), record.reason);
  EXPECT_EQ(written.at("rejected_checkpoints").at(0).at("why"), "damaged");
  EXPECT_FALSE(std::filesystem::exists(run / "attempts/1/exit.json.tmp"));
}

TEST_F(Attempts, LastEntryOfARecordVouchesForAllBeforeIt) {
  const Attempt attempt = Attempt::claim(files, run);
  ExitRecord record;
  record.reason = "it says \"check\": \"\xff\", which is no text";
  write_exit_record(files, attempt.directory(), record);
  const std::string text = content_of(run / "attempts/1/exit.json");
  const std::string before = text.substr(0, text.rfind(','));
  EXPECT_EQ(text.substr(before.size()), ",\n \"check\": \"" + hex(XXH64(before.data(), before.size(), 0)) + "\"\n}\n");
  EXPECT_TRUE(Json::parse(text).contains("reason"));
}

TEST_F(Attempts, ProgressHasTheContractsEntriesAndIsFenced) {
  const Attempt attempt = Attempt::claim(files, run);
  Progress progress;
  progress.step = 12000;
  progress.eta_s = 257.8;
  progress.d_um = 0.81;
  progress.asphericity = 0.12;
  progress.updated_unix_s = 1790000031.2;
  write_progress(files, attempt, progress);
  const std::string before = content_of(run / "progress.json");
  const Json written = Json::parse(before);
  std::set<std::string> names;
  for (const auto& [name, value] : written.items()) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"contract", "attempt", "token", "step", "end_step", "time_s", "end_time_s",
                                          "steps_per_s", "mlups", "eta_s", "checkpoint_step", "checkpoint_unix_s",
                                          "checkpoint_ms", "d_um", "asphericity", "updated_unix_s", "check"}));
  EXPECT_EQ(written.at("updated_unix_s").get<double>(), 1790000031.2);
  const Attempt newer = Attempt::claim(files, run);
  EXPECT_EQ(code_of([&] { write_progress(files, attempt, progress); }), Exit::superseded);
  EXPECT_EQ(content_of(run / "progress.json"), before);
}

}  // namespace
}  // namespace rouleau::testing
