// SPDX-License-Identifier: BSD-3-Clause
// Every file-system call of the real solver fails or kills it, one after the other, those of a continuation that only
// read included; started again, it ends as if nothing had been.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <set>

#include "crash/faults/busy_run.hpp"
#include "crash/faults/plan.hpp"
#include "support/fault_shim/disk_model.hpp"

namespace rouleau::testing {
namespace {

void expect_clear_message(const Injection& injection, const Finished& finished) {
  EXPECT_EQ(finished.code, 74) << finished.err;
  EXPECT_NE(finished.err.find(fmt::format("(errno {})", injection.error_number)), std::string::npos) << finished.err;
  if (injection.error_number != EIO) {
    EXPECT_NE(finished.err.find("Free space or raise the quota"), std::string::npos) << finished.err;
  }
}

/// True if the run may come to its end over a failure of this call: it was synced before (close), or it belongs to the
/// exit record, which comes last and which the exit code makes up for (share/contract.md section 6). All else ends with
/// 74 (section 11). What cannot be read is asked for again (section 10).
bool may_be_passed_over(const Faults& faults, const Injection& injection) {
  if (injection.watch == Watch::reads) return true;
  const StruckCall call = faults.struck();
  if (call.name == "close" || std::filesystem::path(call.path).filename().string().starts_with("exit.json"))
    return true;
  const bool is_last = faults.calls() - injection.at <= 1;
  return is_last && call.path.find("/attempts/") != std::string::npos;
}

/// Runs with the fault; checks how that ended.   returns whether the call was reached
bool disturb(const BusyRun& run, int ranks, const Injection& injection) {
  const Faults faults(run.directory(), solver_program, injection);
  const Finished finished = run.run(ranks);
  if (faults.injected() == 0) {
    EXPECT_EQ(finished.code, 0) << finished.err;
    return false;
  }
  count(injection);
  switch (injection.fault) {
    case Fault::error:
      if (finished.code != 0 || !may_be_passed_over(faults, injection)) {
        SCOPED_TRACE(fmt::format("{} {} {}", faults.struck().name, faults.struck().path, faults.struck().other));
        expect_clear_message(injection, finished);
      }
      break;
    case Fault::brief:
      EXPECT_EQ(finished.code, 0) << finished.err;
      break;
    default:
      EXPECT_NE(finished.code, 0);
  }
  return true;
}

/// What could not be read was not taken for something that is not there.
void expect_no_new_start(const BusyRun& run) {
  for (const auto& entry : std::filesystem::directory_iterator(run.path("attempts"))) {
    const std::filesystem::path record = entry.path() / "exit.json";
    if (entry.path().filename() == "1" || !std::filesystem::exists(record)) continue;
    const auto end = nlohmann::json::parse(content_of(record));
    if (end.at("code") == 0) {
      EXPECT_NE(end.at("resumed_from"), "") << end;
    }
  }
}

/// Goes on without faults; expects the end of an undisturbed run, and that nothing on the disk was taken for damaged.
void expect_undisturbed_end(const BusyRun& run, int ranks, const std::string& end) {
  run.finish(ranks);
  const nlohmann::json record = run.exit_record();
  if (!record.at("rejected_checkpoints").empty()) ++tally().wrong_resumes;
  EXPECT_TRUE(record.at("rejected_checkpoints").empty()) << record;
  const std::string found = run.fingerprint();
  if (found != end) ++tally().lost_samples;
  EXPECT_EQ(found, end);
}

void copy(const BusyRun& from, const BusyRun& to) {
  using Options = std::filesystem::copy_options;
  std::filesystem::copy(from.directory(), to.directory(), Options::recursive | Options::overwrite_existing);
}

/// Of a whole run, or, of reads, the second half of one: most of them belong to the resume.
void expect_no_trace_of_faults(int ranks, int sample, Watch watch = Watch::changes) {
  BusyRun begun;
  if (watch == Watch::reads) {
    begun.set_steps(24);
    begun.finish(ranks);
    begun.set_steps(48);
  }
  const BusyRun undisturbed;
  copy(begun, undisturbed);
  const std::vector<RecordedCall> calls = recorded(undisturbed, ranks, watch);
  const std::string end = undisturbed.fingerprint();
  fmt::print("{} calls on {} ranks\n", calls.size(), ranks);
  int reached = 0;
  for (const Injection& injection : planned_faults(calls, sample, watch)) {
    SCOPED_TRACE(fmt::format("{} at call {} of {}", name_of(injection), injection.at, calls.size()));
    const BusyRun run;
    copy(begun, run);
    if (disturb(run, ranks, injection)) ++reached;
    if (watch == Watch::reads) expect_no_new_start(run);
    expect_undisturbed_end(run, ranks, end);
    if (::testing::Test::HasFailure() && !is_long_form()) return;
  }
  EXPECT_GT(reached, 0);
}

TEST(FaultShim, SeesEveryChangeOfTheSolver) {
  const BusyRun run;
  DiskModel model(run.directory());
  for (const RecordedCall& call : recorded(run, 2)) model.apply(call);
  for (const auto& [name, content] : model.files()) EXPECT_EQ(content, content_of(run.path(name))) << name;
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run.directory())) {
    if (entry.is_regular_file()) ++found;
  }
  EXPECT_EQ(found, model.files().size());
}

/// The first of each kind of call that changes a file: what it does, and which file, whatever its step.
std::vector<RecordedCall> one_of_each_kind(const std::vector<RecordedCall>& calls, const BusyRun& run) {
  const std::set<std::string> changes{"write", "pwrite", "fsync", "rename", "ftruncate", "posix_fallocate"};
  std::set<std::string> known;
  std::vector<RecordedCall> firsts;
  for (const RecordedCall& call : calls) {
    std::string file = std::filesystem::path(call.path).lexically_relative(run.directory()).string();
    std::erase_if(file, [](char c) { return c >= '0' && c <= '9'; });
    if (changes.contains(call.name) && known.insert(call.name + " " + file).second) firsts.push_back(call);
  }
  return firsts;
}

// A solver that took no notice of a failing sync or rename would pass all the tests above: the files are there.
TEST(SolverFaults, OfEachKindAreReported) {
  const auto make = [](BusyRun& run) { run.set_steps(16); };
  BusyRun undisturbed;
  make(undisturbed);
  const std::vector<RecordedCall> kinds = one_of_each_kind(recorded(undisturbed, 1), undisturbed);
  EXPECT_GT(kinds.size(), 20U);
  for (const RecordedCall& call : kinds) {
    SCOPED_TRACE(fmt::format("{} {} at call {}", call.name, call.path, call.number));
    BusyRun run;
    make(run);
    EXPECT_TRUE(disturb(run, 1, {call.number, Fault::error, EIO, false}));
  }
}

TEST(SolverFaults, AtAnyCallLeaveNoTraceOnOneRank) { expect_no_trace_of_faults(1, 14); }
TEST(SolverFaults, AtAnyCallLeaveNoTraceOnTwoRanks) { expect_no_trace_of_faults(2, 4); }
TEST(SolverFaults, AtAnyReadLeaveNoTraceOnOneRank) { expect_no_trace_of_faults(1, 14, Watch::reads); }
TEST(SolverFaults, AtAnyReadLeaveNoTraceOnTwoRanks) { expect_no_trace_of_faults(2, 4, Watch::reads); }

}  // namespace
}  // namespace rouleau::testing
