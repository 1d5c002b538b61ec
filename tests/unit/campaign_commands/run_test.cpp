// SPDX-License-Identifier: BSD-3-Clause
// `rouleau run` and `rouleau sync` without interruption: ends, retries, limits.
#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "executor/cores.hpp"
#include "study/point.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

TEST(CampaignRun, FinishesAllPointsAndTheirResults) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 4, 6", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  const auto capture = program.run();
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(capture.out, "") << "messages belong on stderr";
  const Store store = program.store();
  for (const PointRow& point : store.points()) {
    EXPECT_EQ(point.state, State::done);
    EXPECT_EQ(store.samples(point.key).size(), 11U);
    EXPECT_EQ(store.results(point.key).size(), 1U);
    EXPECT_TRUE(std::filesystem::exists(program.campaign() / "points" / point.key / "result.json"));
    const std::vector<AttemptRow> attempts = store.attempts(point.key);
    ASSERT_EQ(attempts.size(), 1U);
    EXPECT_EQ(attempts[0].state, AttemptState::ended);
    EXPECT_EQ(attempts[0].exit_code, 0);
  }
  EXPECT_TRUE(program.jobs().empty());
}

TEST(CampaignRun, OfAFinishedCampaignDoesNothing) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  ASSERT_EQ(program.run().status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 1U);
}

TEST(CampaignRun, CrashedJobContinuesFromItsCheckpoint) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "crash 70\n-\n");
  const auto capture = program.run();
  ASSERT_EQ(capture.status, 0) << capture.err;
  const auto attempts = program.store().attempts(program.point(1).key);
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_FALSE(attempts[0].exit_code.has_value());
  EXPECT_EQ(attempts[1].start_step, 50);
  EXPECT_EQ(attempts[1].checkpoint_at_start, 50);
  EXPECT_EQ(program.store().samples(program.point(1).key).size(), 11U)
      << "samples after the checkpoint are not doubled";
}

TEST(CampaignRun, CrashesWithoutProgressUseUpTheRetries) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5", CampaignProgram::execution("retries = 2\n"));
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "crash 10\ncrash 20\ncrash 30\n-\n");
  EXPECT_EQ(program.run().status, 4);
  EXPECT_EQ(program.state(1), State::exhausted);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 3U);
  EXPECT_EQ(program.run().status, 4) << "and stays so";
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 3U);
}

TEST(CampaignRun, CrashesAfterProgressDoNot) {
  const CampaignProgram program;
  CampaignProgram::set_speed(100, 10);
  program.write_study("fluid.lambda = 5", CampaignProgram::execution("retries = 1\n"));
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "crash 15\ncrash 25\ncrash 35\ncrash 45\n-\n");
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 5U);
}

TEST(CampaignRun, PhysicsAndBadInputAreNotRetriedAndOthersGoOn) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "exit 70 20\n-\n");
  program.script(2, "exit 65 0\n-\n");
  EXPECT_EQ(program.run().status, 4);
  EXPECT_EQ(program.state(1), State::failed);
  EXPECT_EQ(program.state(2), State::refused);
  EXPECT_EQ(program.state(3), State::done);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 1U);
  EXPECT_THAT(program.store().events(program.point(1).key).back().evidence,
              HasSubstr("exit.json says 70 (scripted end at step 20)"));
}

TEST(CampaignRun, FileErrorIsRetriedAndEarlyStopContinued) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 2", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "exit 74 20\n-\n");
  program.script(2, "exit 75 60\n-\n");
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 2U);
  EXPECT_EQ(program.store().attempts(program.point(2).key).size(), 2U);
}

TEST(CampaignRun, FileErrorsOfAllPointsAreWaitedOutWithTheCountsAsTheyAreByDefault) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1:4:1", "[execution]\njobs = 4\noversubscribe = 1\nio_retry_delay_s = 0.001\n");
  ASSERT_EQ(program.init().status, 0);
  // More often than there are retries, at more points than a pause takes.
  for (int ordinal = 1; ordinal <= 4; ++ordinal)
    program.script(ordinal, "exit 74 0\nexit 74 0\nexit 74 0\nexit 74 0\nexit 74 0\n-\n");
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, ::testing::Not(HasSubstr("paused")));
  for (int ordinal = 1; ordinal <= 4; ++ordinal) {
    EXPECT_EQ(program.state(ordinal), State::done);
    EXPECT_EQ(program.store().attempts(program.point(ordinal).key).size(), 6U);
    EXPECT_EQ(program.point(ordinal).retries_used, 0);
  }
}

TEST(CampaignRun, SolverThatCannotBeStartedAnywherePausesTheCampaign) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1:8:1", "[execution]\njobs = 8\noversubscribe = 1\nio_retry_delay_s = 0\n");
  ASSERT_EQ(program.init().status, 0);
  const std::filesystem::path broken = program.path() / "broken-solver";
  set_content(broken, "#!/nowhere/interpreter\n");
  std::filesystem::permissions(broken, std::filesystem::perms::owner_all);
  ::setenv("ROULEAU_SOLVER", broken.c_str(), 1);
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 4) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("paused: 3 points in a row failed early and alike"));
  EXPECT_THAT(capture.err, HasSubstr("broken-solver: cannot be started: No such file"));
  EXPECT_EQ(program.state(3), State::crashed) << "none of them is given up";
  EXPECT_EQ(program.state(4), State::waiting);
  ::setenv("ROULEAU_SOLVER", FAKE_SOLVER_PROGRAM, 1);
  ASSERT_EQ(program.rouleau({"retry", "--all-failed", "-C", "c"}).status, 0);
  EXPECT_EQ(program.run().status, 0);
}

TEST(CampaignRun, StartsOfOnePassShareTheRoomOfTheDisk) {
  const CampaignProgram program;
  CampaignProgram::set_speed(20000, 1000);  // 2 s: all the while a checkpoint of each may come
  program.write_study("fluid.lambda = 1, 2, 3", "[execution]\njobs = 3\noversubscribe = 1\n");
  ASSERT_EQ(program.init().status, 0);
  const auto free = static_cast<std::int64_t>(std::filesystem::space(program.campaign()).available);
  for (int ordinal = 1; ordinal <= 3; ++ordinal) {
    const std::filesystem::path file = program.run_directory(ordinal) / "point.json";
    Point point = read_point(file);
    point.facts.checkpoint_bytes = free / 3;  // two of them for a start: room for one start, not for two
    write_point(file, point);
  }
  const auto first = program.rouleau({"sync", "c"});
  EXPECT_EQ(program.jobs().size(), 1U) << first.err;
  EXPECT_THAT(first.err, HasSubstr("Points wait until there is room"));
  const auto second = program.rouleau({"sync", "c"});
  EXPECT_EQ(program.jobs().size(), 1U) << "the one that runs has not written its share yet: " << second.err;
  CampaignProgram::set_speed(100, 1000);
  EXPECT_EQ(program.run().status, 0) << "one after the other";
}

TEST(CampaignRun, RunWhoseSamplesWereDamagedMeanwhileIsNotDone) {
  const CampaignProgram program;
  CampaignProgram::set_speed(10000, 50);
  program.write_study("fluid.lambda = 1", CampaignProgram::execution("retries = 1\n"));
  ASSERT_EQ(program.init().status, 0);
  const pid_t run = program.start({"run", "c"});
  const std::filesystem::path log = program.run_directory(1) / "samples.csv";
  const auto third_line = [&] {
    const std::string text = std::filesystem::exists(log) ? content_of(log) : "";
    const std::size_t first = text.find('\n'), second = first == std::string::npos ? first : text.find('\n', first + 1);
    return second == std::string::npos || text.find('\n', second + 1) == std::string::npos ? std::string::npos
                                                                                           : second + 1;
  };
  ASSERT_TRUE(eventually([&] { return third_line() != std::string::npos; }));
  // In place, as a medium does it: the solver appends and never looks back.
  std::fstream(log, std::ios::in | std::ios::out | std::ios::binary)
          .seekp(static_cast<std::streamoff>(third_line()) + 3)
      << "#";
  EXPECT_EQ(CampaignProgram::wait_for(run), 4) << program.messages();
  EXPECT_EQ(program.state(1), State::exhausted) << "this fake solver does not check what its checkpoints counted";
  EXPECT_THAT(program.store().events(program.point(1).key).back().evidence,
              ::testing::AllOf(HasSubstr("exit.json says 0"), HasSubstr("samples.csv: line 3")));
  EXPECT_FALSE(std::filesystem::exists(program.run_directory(1) / "result.json"));
}

TEST(CampaignRun, LogOfADonePointThatIsPurgedTakesNoSamplesAlong) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  const std::string result = content_of(program.run_directory(1) / "result.json");
  std::filesystem::remove(program.run_directory(1) / "samples.csv");
  for (const char* verb : {"sync", "run"}) {
    const auto capture = program.rouleau({verb, "c"});
    EXPECT_EQ(capture.status, 0) << capture.err;
    EXPECT_THAT(capture.err, HasSubstr("samples.csv: is gone. The database keeps the 11 samples"));
  }
  EXPECT_EQ(program.state(1), State::done);
  EXPECT_EQ(program.store().samples(program.point(1).key).size(), 11U);
  EXPECT_EQ(content_of(program.run_directory(1) / "result.json"), result);
}

TEST(CampaignRun, EndWithoutARecordIsACrashWithLastWords) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1", CampaignProgram::execution("retries = 0\n"));
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "mute 9\n");
  EXPECT_EQ(program.run().status, 4);
  EXPECT_THAT(program.store().events(program.point(1).key).back().evidence, HasSubstr("left no exit.json"));
}

TEST(CampaignRun, LikeEarlyFailuresPauseTheCampaign) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1:8:1", "[execution]\njobs = 1\npause_after_failures = 3\n");
  ASSERT_EQ(program.init().status, 0);
  for (int ordinal = 1; ordinal <= 8; ++ordinal)
    program.script(ordinal, "exit 70 " + std::to_string(ordinal) + "\n-\n");
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 4);
  EXPECT_THAT(capture.err,
              HasSubstr("paused: 3 points in a row failed early and alike (exit 70: scripted end at step 3)"));
  EXPECT_EQ(program.state(3), State::failed);
  EXPECT_EQ(program.state(4), State::waiting);
  EXPECT_THAT(program.rouleau({"status", "c"}).err, HasSubstr("paused: 3 points"));
}

TEST(CampaignRun, PauseOutlastsTheProcessUntilTheUserRetries) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1:4:1", "[execution]\njobs = 1\npause_after_failures = 2\n");
  ASSERT_EQ(program.init().status, 0);
  for (int ordinal = 1; ordinal <= 2; ++ordinal) program.script(ordinal, "exit 65 1\n-\n");
  // A pass of cron each: one failure a process.
  for (int ordinal = 1; ordinal <= 2; ++ordinal) {
    ASSERT_LE(program.rouleau({"sync", "c"}).status, 4);
    ASSERT_TRUE(eventually([&] { return program.jobs().empty(); }));
  }
  // The last one may still be on its way out when nothing of it is seen any more.
  EXPECT_TRUE(eventually([&] {
    return program.rouleau({"sync", "c"}).err.find("paused: 2 points in a row") != std::string::npos;
  }));
  EXPECT_EQ(program.run().status, 4);
  EXPECT_EQ(program.state(3), State::waiting);
  ASSERT_EQ(program.rouleau({"retry", "--all-failed", "-C", "c"}).status, 0);
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.state(4), State::done);
}

TEST(CampaignRun, JobsAtATimeHaveDifferentCores) {
  if (allowed_cores().size() < 2) GTEST_SKIP() << "one core only";
  const CampaignProgram program;
  CampaignProgram::set_speed(5000, 50);
  program.write_study("fluid.lambda = 1:4:1", "[execution]\njobs = 2\n");
  ASSERT_EQ(program.init().status, 0);
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(eventually([&] { return program.jobs().size() == 2; }));
  std::set<int> used;
  for (const pid_t job : program.jobs()) {
    ASSERT_EQ(cores_of(job).size(), 1U);
    used.insert(cores_of(job).front());
  }
  EXPECT_EQ(used.size(), 2U);
  EXPECT_EQ(CampaignProgram::wait_for(run), 0);
}

TEST(CampaignRun, MoreRanksThanCoresAreRefusedUnlessTold) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1", "[execution]\nranks = 4096\n");
  ASSERT_EQ(program.init().status, 0);
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("ranks = 4096"));
  EXPECT_EQ(program.state(1), State::waiting);
}

TEST(CampaignRun, MissingSolverIsSaidBeforeAnythingIsStarted) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  ASSERT_EQ(program.init().status, 0);
  ::setenv("ROULEAU_SOLVER", "/nowhere/solver", 1);
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.err, HasSubstr("ROULEAU_SOLVER = /nowhere/solver"));
  EXPECT_EQ(program.state(1), State::waiting);
}

TEST(CampaignRun, DamagedPointDoesNotStopTheOthers) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 2", CampaignProgram::execution("retries = 0\n"));
  ASSERT_EQ(program.init().status, 0);
  set_content(program.run_directory(1) / "point.json", "{");
  EXPECT_EQ(program.run().status, 4);
  EXPECT_EQ(program.state(1), State::exhausted);
  EXPECT_THAT(program.store().events(program.point(1).key).back().evidence, HasSubstr("point.json"));
  EXPECT_EQ(program.state(2), State::done);
}

TEST(CampaignSync, RecordsAndStartsWithoutWaiting) {
  const CampaignProgram program;
  CampaignProgram::set_speed(20000, 20);  // 2 s: three calls of rouleau fit in
  program.write_study("fluid.lambda = 1", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.rouleau({"sync", "c", "--no-start"}).status, 0);
  EXPECT_EQ(program.state(1), State::waiting);
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);
  EXPECT_EQ(program.state(1), State::running);
  EXPECT_EQ(program.jobs().size(), 1U);
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).size(), 1U) << "a running point is not started again";
  ASSERT_TRUE(eventually([&] { return program.jobs().empty(); }));
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);
  EXPECT_EQ(program.state(1), State::done);
}

}  // namespace
}  // namespace rouleau::campaign
