// SPDX-License-Identifier: BSD-3-Clause
// `rouleau cancel` and `rouleau retry`.
#include <gmock/gmock.h>

#include "study/point.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::AnyOf;
using ::testing::HasSubstr;

TEST(CampaignCancel, WaitingPointIsNotRunUntilRetried) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const auto capture = program.rouleau({"cancel", "lambda=5", "-C", "c"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(program.state(2), State::cancelled);
  EXPECT_TRUE(read_point(program.run_directory(2) / "point.json").cancelled) << "a rebuilt database must know";
  EXPECT_EQ(program.run().status, 0) << "a cancelled point is no failure";
  EXPECT_EQ(program.state(1), State::done);
  EXPECT_EQ(program.state(2), State::cancelled);
  ASSERT_EQ(program.rouleau({"retry", "#2", "-C", "c"}).status, 0);
  EXPECT_EQ(program.state(2), State::waiting);
  EXPECT_FALSE(read_point(program.run_directory(2) / "point.json").cancelled);
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.state(2), State::done);
}

TEST(CampaignCancel, RunningJobStopsWhileTheManagerRuns) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "hang 30\n-\n");
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(
      eventually([&] { return std::filesystem::exists(program.run_directory(1) / "attempts/1/started.json"); }));
  const auto capture = program.rouleau({"cancel", "#1", "-C", "c"});
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, AnyOf(HasSubstr("handed to the rouleau"), HasSubstr("carried out by the rouleau")));
  EXPECT_EQ(CampaignProgram::wait_for(run), 0);
  EXPECT_EQ(program.state(1), State::cancelled);
  EXPECT_EQ(program.state(2), State::done);
  const auto attempts = program.store().attempts(program.point(1).key);
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts[0].exit_code, 75);
  EXPECT_TRUE(std::filesystem::is_empty(program.campaign() / "requests"));

  CampaignProgram::set_speed(10, 1000);
  ASSERT_EQ(program.rouleau({"retry", "#1", "-C", "c"}).status, 0);
  EXPECT_EQ(program.state(1), State::stopped) << "from its checkpoint, not from the start";
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.store().attempts(program.point(1).key).at(1).start_step, attempts[0].step);
}

TEST(CampaignCancel, RequestThatIsNoneIsNamedAndLeft) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const std::filesystem::path strange = program.campaign() / "requests/strange";
  std::filesystem::create_directories(program.campaign() / "requests/a-folder");
  set_content(strange, "cancel everything\n");
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr(strange.string() + ": holds neither `cancel` nor `retry`"));
  EXPECT_THAT(capture.err, HasSubstr("requests/a-folder: "));
  EXPECT_TRUE(std::filesystem::exists(strange));
}

TEST(CampaignCancel, DonePointIsNotCancelled) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  const auto capture = program.rouleau({"cancel", "#1", "-C", "c"});
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.err, HasSubstr("is done; there is nothing to cancel"));
  EXPECT_EQ(program.state(1), State::done);
}

TEST(CampaignRetry, RevivesWhatFailedWithFreshRetries) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution("retries = 0\n"));
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "exit 70 20\n-\n");
  program.script(2, "crash 20\n-\n");
  ASSERT_EQ(program.run().status, 4);
  EXPECT_EQ(program.state(1), State::failed);
  EXPECT_EQ(program.state(2), State::exhausted);
  const auto capture = program.rouleau({"retry", "--all-failed", "-C", "c"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(program.run().status, 0);
  EXPECT_EQ(program.rouleau({"retry", "--all-failed", "-C", "c"}).status, 3) << "nothing is left to retry";
}

TEST(CampaignRetry, OfADonePointIsRefused) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  const auto capture = program.rouleau({"retry", "#1", "-C", "c"});
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.err, HasSubstr("is done"));
  EXPECT_EQ(program.rouleau({"retry", "#9", "-C", "c"}).status, 3);
}

}  // namespace
}  // namespace rouleau::campaign
