// SPDX-License-Identifier: BSD-3-Clause
// One run directory that cannot be read keeps nobody from the others.
#include <gmock/gmock.h>

#include <functional>

#include "crash/damage/figures.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

namespace fs = std::filesystem;
using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

/// What befalls the run directory of point 2.
struct Trouble {
  const char* name;
  std::function<void(const fs::path& run)> strike;
};

void make_a_folder_of(const fs::path& file) {
  fs::remove_all(file);
  fs::create_directories(file / "within");
}
void make_a_file_of(const fs::path& folder) {
  fs::remove_all(folder);
  set_content(folder, "not a folder");
}

/// Looking at it fails with ELOOP: for root, too, who is refused nothing.
void make_a_loop_of(const fs::path& place) {
  fs::remove_all(place);
  fs::create_symlink(place.filename(), place);
}

const std::vector<Trouble> troubles = {
    {"SamplesAreAFolder", [](const fs::path& run) { make_a_folder_of(run / "samples.csv"); }},
    {"ProgressIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "progress.json"); }},
    {"RunFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "run.ini"); }},
    {"RunFileIsGone", [](const fs::path& run) { fs::remove(run / "run.ini"); }},
    {"PointFileIsRubbish", [](const fs::path& run) { set_content(run / "point.json", std::string(300, '\xff')); }},
    {"PointFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "point.json"); }},
    {"AttemptsAreAFile", [](const fs::path& run) { make_a_file_of(run / "attempts"); }},
    {"CheckpointsAreAFile", [](const fs::path& run) { make_a_file_of(run / "checkpoints"); }},
    {"ExitRecordIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "attempts/1/exit.json"); }},
    {"OwnerIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "attempts/1/owner"); }},
    {"LogIsRubbish", [](const fs::path& run) { set_content(run / "samples.csv", std::string(9000, '\xff')); }},
    {"StopFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "stop"); }},
    {"EverythingIsGone", [](const fs::path& run) { fs::remove_all(run); }},
    {"TheDirectoryIsAFile", [](const fs::path& run) { make_a_file_of(run); }},
    {"TheDirectoryIsALoop", [](const fs::path& run) { make_a_loop_of(run); }},
    {"AttemptsAreALoop", [](const fs::path& run) { make_a_loop_of(run / "attempts"); }},
    {"CheckpointsAreALoop", [](const fs::path& run) { make_a_loop_of(run / "checkpoints"); }},
    {"SamplesAreALoop", [](const fs::path& run) { make_a_loop_of(run / "samples.csv"); }},
};

class UnreadableRun : public ::testing::TestWithParam<Trouble> {};

TEST_P(UnreadableRun, DoesNotKeepAnybodyFromTheOthers) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5, 8", CampaignProgram::execution("retries = 1\n"));
  ASSERT_EQ(program.init().status, 0);
  GetParam().strike(program.run_directory(2));
  ++rouleau::testing::figures().damage_positions;

  const auto before = program.rouleau({"status", "c"});
  EXPECT_EQ(before.status, 0) << before.err;
  for (const char* point : {"#1", "#2", "#3"}) EXPECT_THAT(before.out, HasSubstr(point));
  // Pass by pass: a directory that cannot be written is waited for as long as it takes.
  rouleau::testing::CampaignProgram::Capture pass;
  EXPECT_TRUE(eventually([&] {
    pass = program.rouleau({"sync", "c"});
    EXPECT_TRUE(pass.status == 0 || pass.status == 4) << pass.status << pass.err;
    return HasFailure() || (program.state(1) == State::done && program.state(3) == State::done);
  })) << pass.err;
  for (const char* verb : {"sync", "status", "verify", "query", "rebuild"}) {
    const auto answer = program.rouleau({verb, "c"});
    EXPECT_LT(answer.status, 8) << verb << " died: " << answer.err;
  }
  EXPECT_EQ(program.point(1).state, State::done);
}

INSTANTIATE_TEST_SUITE_P(, UnreadableRun, ::testing::ValuesIn(troubles),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(UnseenRun, IsNamedAndLeftAloneUntilItIsSeenAgain) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "hang 60\n");
  const pid_t manager = program.start({"run", "c"});
  const fs::path run = program.run_directory(1), away = program.path() / "away";
  EXPECT_TRUE(
      eventually([&] { return program.state(2) == State::done && fs::exists(run / "checkpoints/000000000050.h5"); }));
  ::kill(manager, SIGKILL);
  CampaignProgram::wait_for(manager);
  const auto samples = program.store().samples(program.point(1).key);
  const auto attempts = program.store().attempts(program.point(1).key);
  fs::rename(run, away);
  make_a_loop_of(run);
  ++rouleau::testing::figures().damage_positions;

  const auto pass = program.rouleau({"sync", "c"});
  EXPECT_EQ(pass.status, 0) << pass.err;
  EXPECT_THAT(pass.err, HasSubstr("warning: #1"));
  const auto status = program.rouleau({"status", "c"});
  EXPECT_EQ(status.status, 0) << status.err;
  EXPECT_THAT(status.out, HasSubstr(run.filename().string() + "/checkpoints: cannot be listed"));
  EXPECT_EQ(program.state(1), State::running) << "what cannot be seen is no evidence";
  EXPECT_EQ(program.store().attempts(program.point(1).key), attempts);
  EXPECT_EQ(program.store().samples(program.point(1).key), samples);

  fs::remove(run);
  fs::rename(away, run);
  for (const pid_t job : program.jobs()) ::kill(job, SIGKILL);
  const auto end = program.run();
  EXPECT_EQ(end.status, 0) << end.err;
}

// The job was taken for ended: `run` said "1 running" and left with 0.
TEST(UnseenRun, OfTheLastJobEndsNoManager) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "hang 50\n");  // with no step after the checkpoint: it would miss its folder and end
  const pid_t manager = program.start({"run", "c"});
  const fs::path run = program.run_directory(1), attempts = run / "attempts", away = run / "away";
  EXPECT_TRUE(eventually([&] { return fs::exists(run / "checkpoints/000000000050.h5"); }));
  fs::rename(attempts, away);
  make_a_loop_of(attempts);
  ++rouleau::testing::figures().damage_positions;
  EXPECT_TRUE(eventually([&] { return program.messages().find("cannot be listed") != std::string::npos; }));
  std::this_thread::sleep_for(std::chrono::seconds(2));  // a few passes more
  int status = 0;
  EXPECT_EQ(::waitpid(manager, &status, WNOHANG), 0) << program.messages();
  fs::remove(attempts);
  fs::rename(away, attempts);
  for (const pid_t job : program.jobs()) ::kill(job, SIGKILL);
  EXPECT_EQ(CampaignProgram::wait_for(manager), 0) << program.messages();
  EXPECT_EQ(program.state(1), State::done);
}

}  // namespace
}  // namespace rouleau::campaign
