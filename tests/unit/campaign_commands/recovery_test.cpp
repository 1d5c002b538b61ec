// SPDX-License-Identifier: BSD-3-Clause
// What `rouleau run` makes of situations that a crash, a person or another host has left.
#include <gmock/gmock.h>

#include "executor/attempt.hpp"
#include "executor/local.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

class Recovery : public ::testing::Test {
 protected:
  Recovery() {
    program_.write_study("fluid.lambda = 5", CampaignProgram::execution());
    EXPECT_EQ(program_.init().status, 0);
  }
  /// Records attempt 1 as a manager does just before it starts one.
  void record_intent(AttemptState state) const {
    Store store = Store::open(program_.campaign() / "campaign.db");
    const std::string key = store.points().at(0).key;
    AttemptRow attempt;
    attempt.point = key;
    attempt.number = 1;
    attempt.token = "token";
    attempt.state = state;
    attempt.host = host_name();
    attempt.ranks = 1;
    attempt.started_unix_s = now_unix_s();
    store.put_attempt(attempt);
    store.change_state(key, State::waiting, State::running, "attempt 1 is started", 1);
  }
  /// Claims attempt 1 and starts it.
  ProcessIdentity claim_and_launch(LocalExecutor& executor) const {
    claim_attempt(program_.run_directory(1), 1, "token");
    return executor.launch({FAKE_SOLVER_PROGRAM, program_.run_directory(1), 1, "token", 1, -1, {}, 0});
  }
  /// As if that process had been started for attempt 1.
  void leave_attempt_of(const ProcessIdentity& process) const {
    record_intent(AttemptState::launched);
    const auto run = program_.run_directory(1);
    claim_attempt(run, 1, "token");
    set_content(run / "attempts/1/process.json", process_json(process, 1, -1));
  }
  void expect_done_in(std::size_t attempts) const {
    const auto capture = program_.run();
    EXPECT_EQ(capture.status, 0) << capture.err;
    EXPECT_EQ(program_.state(1), State::done);
    EXPECT_EQ(program_.store().attempts(program_.point(1).key).size(), attempts);
    EXPECT_EQ(program_.point(1).retries_used, 0);
  }
  CampaignProgram program_;
};

TEST_F(Recovery, KilledBetweenIntentAndClaim) {
  record_intent(AttemptState::planned);
  expect_done_in(2);
}

TEST_F(Recovery, KilledBetweenClaimAndStart) {
  record_intent(AttemptState::planned);
  claim_attempt(program_.run_directory(1), 1, "token");
  expect_done_in(2);
}

TEST_F(Recovery, KilledBetweenStartAndItsRecord) {
  CampaignProgram::set_speed(10000, 50);
  record_intent(AttemptState::planned);
  LocalExecutor executor;
  const ProcessIdentity process = claim_and_launch(executor);
  EXPECT_EQ(executor.life(process), Life::alive);
  expect_done_in(1);
  executor.reap();
}

TEST_F(Recovery, UnreadableProcessFileIsNoProofThatNothingRuns) {
  CampaignProgram::set_speed(10000, 50);
  record_intent(AttemptState::planned);
  LocalExecutor executor;
  const ProcessIdentity process = claim_and_launch(executor);
  {
    Store store = Store::open(program_.campaign() / "campaign.db");
    AttemptRow attempt = store.attempts(program_.point(1).key).at(0);
    attempt.state = AttemptState::launched;
    attempt.boot_id = process.boot_id;
    attempt.pid = process.pid;
    attempt.start_ticks = process.start_ticks;
    store.put_attempt(attempt);
  }
  set_content(program_.run_directory(1) / "attempts/1/process.json", "torn");
  expect_done_in(1);
  executor.reap();
}

TEST_F(Recovery, EndedWhileNobodyWatched) {
  record_intent(AttemptState::launched);
  LocalExecutor executor;
  const ProcessIdentity process = claim_and_launch(executor);
  ASSERT_TRUE(eventually([&] { return executor.life(process) == Life::dead; }));
  executor.reap();
  expect_done_in(1);
}

TEST_F(Recovery, RunByHandIsTakenOver) {
  const auto by_hand = run_and_capture({FAKE_SOLVER_PROGRAM, "run.ini"}, program_.run_directory(1));
  ASSERT_EQ(by_hand.status, 0) << by_hand.err;
  expect_done_in(1);
}

TEST_F(Recovery, DoneWithoutItsResultFileGetsOne) {
  expect_done_in(1);
  const auto file = program_.run_directory(1) / "result.json";
  std::filesystem::remove(file);
  expect_done_in(1);
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(Recovery, StaleStopFileDoesNotStopTheNextStart) {
  make_stop_file(program_.run_directory(1));
  expect_done_in(1);
}

TEST_F(Recovery, ProcessOfAnEarlierBootIsGoneThoughItsNumberLives) {
  ProcessIdentity process = identity_of(::getpid()).value();
  process.boot_id = "00000000-0000-0000-0000-000000000000";
  leave_attempt_of(process);
  expect_done_in(2);
}

TEST_F(Recovery, ProcessWhoseNumberIsAnothersNowIsGone) {
  ProcessIdentity process = identity_of(::getpid()).value();
  --process.start_ticks;
  leave_attempt_of(process);
  expect_done_in(2);
}

TEST_F(Recovery, OtherHostIsNotGuessedAbout) {
  leave_attempt_of({"elsewhere", "some-boot", 4711, 12345});
  const auto capture = program_.run();
  EXPECT_EQ(capture.status, 4);
  EXPECT_THAT(capture.err, HasSubstr("was started on host elsewhere"));
  EXPECT_EQ(program_.state(1), State::running) << "silence changes nothing";
  ASSERT_EQ(program_.rouleau({"retry", "#1", "-C", "c"}).status, 0) << "but the user may decide";
  expect_done_in(2);
}

TEST_F(Recovery, OldAttemptIsFencedOffByTheNext) {
  CampaignProgram::set_speed(3000, 5);
  const auto run = program_.run_directory(1);
  LocalExecutor executor;
  claim_attempt(run, 1, "token");
  const ProcessIdentity old = executor.launch({FAKE_SOLVER_PROGRAM, run, 1, "token", 1, -1, {}, 0});
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(run / "attempts/1/started.json"); }));
  claim_attempt(run, 2, "other");
  ASSERT_TRUE(eventually([&] { return executor.life(old) == Life::dead; })) << "it must notice within a few steps";
  executor.reap();
  EXPECT_FALSE(std::filesystem::exists(run / "attempts/1/exit.json"));
  CampaignProgram::set_speed(100, 50);
  expect_done_in(3);
}

}  // namespace
}  // namespace rouleau::campaign
