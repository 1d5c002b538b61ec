// SPDX-License-Identifier: BSD-3-Clause
// A submission that nobody saw for so long that its point was submitted anew: its held job must not stay in the queue.
#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::FakeCampaign;

TEST(Submission, ThatArrivesAfterItWasGivenUpIsNoOrphan) {
  const FakeCampaign campaign("5", "client_timeout_s = 1\n");
  campaign.slurm.set("invisible", "4");
  campaign.slurm.set("sbatch_sleeps_after", "30");
  ASSERT_EQ(campaign.sync().status, 0);
  campaign.slurm.unset("sbatch_sleeps_after");
  campaign.slurm.unset("invisible");
  campaign.age_submissions();
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_TRUE(campaign.sync_until([&] { return campaign.slurm.living().empty(); })) << "the late job is held for ever";
}

}  // namespace
}  // namespace rouleau::campaign
