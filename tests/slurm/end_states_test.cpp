// SPDX-License-Identifier: BSD-3-Clause
// Every way in which Slurm ends a job: named in plain words, counted or not, and followed by the right move.
#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::eventually;
using rouleau::testing::FakeCampaign;
using rouleau::testing::FakeSlurm;
using ::testing::HasSubstr;

struct End {
  const char* state;
  const char* words;
  bool is_counted;  ///< without progress, as one of the retries
};

class JobEnd : public ::testing::TestWithParam<End> {};

TEST_P(JobEnd, BehindACheckpointIsGoneOnFrom) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, GetParam().state, "kill"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_THAT(campaign.why(1), HasSubstr(GetParam().words));
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_EQ(campaign.program.store().attempts(campaign.program.point(1).key)[1].start_step, 50);
}

TEST_P(JobEnd, WithoutProgressCountsOnlyIfTheRunMayBeItsCause) {
  const FakeCampaign campaign("5", "", "retries = 1\n");
  campaign.script(1, "hang 10\nhang 10\nhang 10\n");
  for (int start = 1; start <= 2; ++start) {
    ASSERT_TRUE(campaign.sync_until([&] {
      const auto jobs = campaign.slurm.jobs();
      const auto started = campaign.program.run_directory(1) / fmt::format("attempts/{}/started.json", start);
      return static_cast<int>(jobs.size()) == start && std::filesystem::exists(started);
    })) << campaign.last_words();
    campaign.slurm.control({"end", campaign.slurm.jobs().back().id, GetParam().state, "kill"});
  }
  const State expected = GetParam().is_counted ? State::exhausted : State::running;
  EXPECT_TRUE(campaign.sync_until([&] { return campaign.program.state(1) == expected; })) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), GetParam().is_counted ? 2U : 3U);
}

INSTANTIATE_TEST_SUITE_P(Slurm, JobEnd,
                         ::testing::Values(End{"PREEMPTED", "preempted", false},
                                           End{"NODE_FAIL", "node failure", false},
                                           End{"BOOT_FAIL", "did not boot", false}, End{"TIMEOUT", "time limit", true},
                                           End{"DEADLINE", "deadline", true},
                                           End{"OUT_OF_MEMORY", "out of memory", true},
                                           End{"CANCELLED", "cancelled", true}),
                         [](const auto& test) {
                           std::string name = test.param.state;
                           std::erase(name, '_');
                           return name;
                         });

TEST(FailedJob, OfASolverThatCrashesIsRetriedOnlySoOften) {
  const FakeCampaign campaign("5", "", "retries = 2\n");
  campaign.script(1, "mute 9\nmute 9\nmute 9\nmute 9\nmute 9\nmute 9\n");
  ASSERT_TRUE(campaign.sync_until([&] {
    // Slurm says FAILED, NonZeroExitCode before the next look.
    return eventually([&] { return campaign.slurm.living().empty(); }) && is_final(campaign.program.state(1));
  })) << campaign.last_words();
  EXPECT_EQ(campaign.program.state(1), State::exhausted) << campaign.why(1);
  EXPECT_EQ(campaign.slurm.jobs().size(), 3U);
}

TEST(FailedJob, ThatTheSolverFinishedIsDone) {
  // Slurm's word for a job whose controller died: FAILED, though the solver came to its end.
  const FakeCampaign campaign;
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, "FAILED", "kill", "JobLaunchFailure"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

TEST(FailedJob, OfBadInputOrFailedPhysicsIsNotRetried) {
  const FakeCampaign campaign("4, 5");
  campaign.script(1, "exit 65 0\n");
  campaign.script(2, "exit 70 60\n");
  ASSERT_TRUE(campaign.sync_until([&] {
    return is_final(campaign.program.state(1)) && is_final(campaign.program.state(2));
  })) << campaign.last_words();
  EXPECT_EQ(campaign.program.state(1), State::refused);
  EXPECT_EQ(campaign.program.state(2), State::failed);
  EXPECT_EQ(campaign.slurm.jobs().size(), 2U);
}

}  // namespace
}  // namespace rouleau::campaign
