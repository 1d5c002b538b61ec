// SPDX-License-Identifier: BSD-3-Clause
// kill -9 of the manager at each step of a submission: no point has two jobs, no job is left over, all is found again.
#include <random>

#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::FakeCampaign;
using rouleau::testing::FakeSlurm;

/// Where the manager dies: before or after a client has done its work.
struct Moment {
  const char* name;
  const char* client;
  const char* when;
  std::size_t jobs;  ///< that Slurm knows at the death
  const char* reason;
};

class KilledManager : public ::testing::TestWithParam<Moment> {};

TEST_P(KilledManager, IsFollowedByOneThatFindsTheJob) {
  const FakeCampaign campaign;
  campaign.slurm.set("pending_reason", "Licenses");
  campaign.slurm.control({"kill-caller", GetParam().client, GetParam().when});
  EXPECT_EQ(CampaignProgram::wait_for(campaign.program.start({"sync", "c"})), 1000 + SIGKILL);
  // The client may go on for a moment behind the manager's back, as a real one would.
  ASSERT_TRUE(eventually([&] { return campaign.slurm.jobs().size() == GetParam().jobs; }));
  if (GetParam().jobs > 0) {
    ASSERT_TRUE(eventually([&] { return campaign.slurm.jobs()[0].reason == GetParam().reason; }));
  }

  for (int pass = 0; pass < 2; ++pass) {
    ASSERT_EQ(campaign.sync().status, 0);
    EXPECT_LE(campaign.most_living_jobs_of_a_point(), 1);
  }
  campaign.age_submissions();  // one of which nothing was seen for a minute has not happened
  ASSERT_TRUE(campaign.sync_until([&] { return campaign.slurm.living().size() == 1; })) << campaign.last_words();
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.slurm.living()[0].reason, "Licenses") << "it was not released";
  campaign.slurm.unset("pending_reason");
  campaign.slurm.control({"pend", campaign.slurm.living()[0].id, "None"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  EXPECT_EQ(campaign.program.rouleau({"verify", "c"}).status, 0);
}

INSTANTIATE_TEST_SUITE_P(Moments, KilledManager,
                         ::testing::Values(Moment{"BeforeTheLook", "squeue", "before", 0, ""},
                                           Moment{"AfterTheLook", "squeue", "after", 0, ""},
                                           Moment{"BehindTheIntent", "sbatch", "before", 0, ""},
                                           Moment{"BehindTheSubmission", "sbatch", "after", 1, "JobHeldUser"},
                                           Moment{"BehindTheRecord", "scontrol", "before", 1, "Licenses"},
                                           Moment{"BehindTheRelease", "scontrol", "after", 1, "Licenses"}),
                         [](const auto& test) { return test.param.name; });

TEST(KilledManager, AtRandomMomentsLeavesNoTrace) {
  const FakeCampaign calm("1:6:1", "jobs = 3\n");
  ASSERT_TRUE(calm.sync_until_all(State::done)) << calm.last_words();
  const FakeCampaign campaign("1:6:1", "jobs = 3\n");
  std::mt19937 random(6);
  using Clock = std::chrono::steady_clock;
  Clock::duration pass = std::chrono::milliseconds(400);  // how long the last one took that was left alone
  constexpr int kills = 12, most_tries = 200;
  int killed = 0, most = 0;
  for (int attempt = 0; attempt < most_tries && killed < kills; ++attempt) {
    const Clock::time_point begin = Clock::now();
    const pid_t manager = campaign.program.start({"sync", "c"});
    std::this_thread::sleep_for(pass * std::uniform_real_distribution<>(0, 1)(random));
    ::kill(manager, SIGKILL);
    if (CampaignProgram::wait_for(manager) == 1000 + SIGKILL) {
      ++killed;
    } else {
      pass = std::min<Clock::duration>(pass, Clock::now() - begin);
    }
    most = std::max(most, campaign.most_living_jobs_of_a_point());
    campaign.age_submissions();
  }
  EXPECT_EQ(killed, kills) << "the test proves nothing";
  ASSERT_TRUE(campaign.sync_until([&] {
    campaign.age_submissions();
    most = std::max(most, campaign.most_living_jobs_of_a_point());
    for (const PointRow& point : campaign.program.store().points()) {
      if (point.state != State::done) return false;
    }
    return true;
  })) << campaign.last_words();
  EXPECT_LE(most, 1);
  EXPECT_TRUE(campaign.sync_until([&] { return campaign.slurm.living().empty(); })) << "a job is left over";
  ::testing::Test::RecordProperty("kills", killed);
  ::testing::Test::RecordProperty("jobs", static_cast<int>(campaign.slurm.jobs().size()));
  EXPECT_EQ(campaign.program.rouleau({"verify", "c"}).status, 0);
}

}  // namespace
}  // namespace rouleau::campaign
