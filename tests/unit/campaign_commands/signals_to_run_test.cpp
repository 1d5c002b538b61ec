// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C, twice, SIGTERM, SIGHUP: what they do to `rouleau run` and its jobs.
#include <gmock/gmock.h>

#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using ::testing::HasSubstr;

class SignalToRun : public ::testing::Test {
 protected:
  SignalToRun() {
    CampaignProgram::set_speed(4000, 1000);  // 2 s a point; no checkpoint of its own accord
    program_.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution(), "0.05");
    EXPECT_EQ(program_.init().status, 0);
    run_ = program_.start({"run", "c"});
    EXPECT_TRUE(eventually([&] { return has_started(1) && has_started(2); }));
  }
  bool has_started(int ordinal) const {
    return std::filesystem::exists(program_.run_directory(ordinal) / "attempts/1/started.json");
  }
  /// What a later run makes of it.
  void finish() const {
    CampaignProgram::set_speed(10, 1000);
    const auto capture = program_.run();
    EXPECT_EQ(capture.status, 0) << capture.err;
    for (int ordinal = 1; ordinal <= 3; ++ordinal) EXPECT_EQ(program_.state(ordinal), State::done);
    EXPECT_TRUE(program_.jobs().empty());
  }
  CampaignProgram program_;
  pid_t run_ = 0;
};

TEST_F(SignalToRun, CtrlCOnceStopsJobsBehindACheckpoint) {
  ::kill(run_, SIGINT);
  EXPECT_EQ(CampaignProgram::wait_for(run_), 130);
  EXPECT_TRUE(program_.jobs().empty());
  EXPECT_EQ(program_.state(1), State::stopped);
  EXPECT_EQ(program_.state(3), State::waiting);
  EXPECT_THAT(program_.messages(), HasSubstr("stopping: 2 jobs"));
  EXPECT_FALSE(std::filesystem::exists(program_.run_directory(1) / "stop")) << "it would stop the next start too";
  const auto attempt = program_.store().attempts(program_.point(1).key).at(0);
  EXPECT_EQ(attempt.exit_code, 75);
  EXPECT_GT(attempt.step.value(), 0);
  finish();
  EXPECT_EQ(program_.store().attempts(program_.point(1).key).at(1).start_step, attempt.step);
}

TEST_F(SignalToRun, TermIsLikeCtrlC) {
  ::kill(run_, SIGTERM);
  EXPECT_EQ(CampaignProgram::wait_for(run_), 130);
  EXPECT_TRUE(program_.jobs().empty());
  EXPECT_EQ(program_.state(1), State::stopped);
  finish();
}

TEST_F(SignalToRun, CtrlCTwiceDoesNotWait) {
  ::kill(run_, SIGSTOP);  // so that both signals are there before it looks
  ::kill(run_, SIGINT);
  ::kill(run_, SIGTERM);
  ::kill(run_, SIGCONT);
  EXPECT_EQ(CampaignProgram::wait_for(run_), 130);
  ASSERT_TRUE(eventually([&] { return program_.jobs().empty(); })) << "asked to stop, they end by themselves";
  finish();
}

TEST_F(SignalToRun, HangUpLetsGoAndJobsGoOn) {
  ::kill(run_, SIGHUP);
  EXPECT_EQ(CampaignProgram::wait_for(run_), 130);
  EXPECT_EQ(program_.jobs().size(), 2U);
  CampaignProgram::set_speed(10, 1000);
  const auto capture = program_.run();
  EXPECT_EQ(capture.status, 0);
  EXPECT_THAT(capture.err, HasSubstr("attempt 1 is still running; taken over"));
  EXPECT_EQ(program_.store().attempts(program_.point(1).key).size(), 1U);
}

TEST_F(SignalToRun, KilledManagerLeavesJobsThatAreTakenOver) {
  ::kill(run_, SIGKILL);
  CampaignProgram::wait_for(run_);
  EXPECT_EQ(program_.jobs().size(), 2U);
  finish();
  for (int ordinal = 1; ordinal <= 3; ++ordinal) {
    EXPECT_EQ(program_.store().attempts(program_.point(ordinal).key).size(), 1U) << "nothing was started twice";
  }
}

TEST_F(SignalToRun, SecondManagerIsRefusedAndToldWhoHasTheLock) {
  const auto capture = program_.run();
  EXPECT_EQ(capture.status, 5);
  EXPECT_THAT(capture.err, HasSubstr("`rouleau run` (process " + std::to_string(run_)));
  EXPECT_EQ(program_.rouleau({"status", "c"}).status, 0) << "readers need no lock";
  ::kill(run_, SIGINT);
  CampaignProgram::wait_for(run_);
}

TEST_F(SignalToRun, FrozenManagerIsNotRobbedAndReadersDoNotWaitForIt) {
  ::kill(run_, SIGSTOP);
  EXPECT_EQ(program_.run().status, 5);
  EXPECT_EQ(program_.rouleau({"sync", "c"}).status, 5);
  EXPECT_EQ(program_.rouleau({"status", "c"}).status, 0);
  EXPECT_EQ(program_.rouleau({"why", "#1", "-C", "c"}).status, 0);
  EXPECT_EQ(program_.jobs().size(), 2U) << "nobody has touched its jobs";
  ::kill(run_, SIGCONT);
  ::kill(run_, SIGINT);
  EXPECT_EQ(CampaignProgram::wait_for(run_), 130);
  finish();
}

TEST(SignalToMpirun, ReachesTheSolverBehindIt) {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  const CampaignProgram program;
  CampaignProgram::set_speed(5000, 100000);
  program.write_study("fluid.lambda = 1", CampaignProgram::execution("ranks = 2\n"), "0.2");
  ASSERT_EQ(program.init().status, 0);
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(
      eventually([&] { return std::filesystem::exists(program.run_directory(1) / "attempts/1/started.json"); }));
  ::kill(run, SIGINT);
  EXPECT_EQ(CampaignProgram::wait_for(run), 130);
  EXPECT_EQ(program.state(1), State::stopped);
  const auto attempt = program.store().attempts(program.point(1).key).at(0);
  EXPECT_EQ(attempt.exit_code, 75);
  EXPECT_TRUE(program.jobs().empty());
  CampaignProgram::set_speed(10, 100000);
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).at(1).start_step, attempt.step);
}

}  // namespace
}  // namespace rouleau::campaign
