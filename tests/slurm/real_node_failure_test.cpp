// SPDX-License-Identifier: BSD-3-Clause
// A node's daemon dies while its job runs on: Slurm starts the job again on the other node, and two copies are alive.
#include "slurm/real_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::RealCampaign;
using rouleau::testing::SlurmSandbox;
using ::testing::HasSubstr;

TEST(RealSlurm, NodeFailureWithBothCopiesAliveLeavesNoTrace) {
  const SlurmSandbox sandbox({"SANDBOX_NODE_TIMEOUT=5"});
  const RealCampaign campaign("5");
  const pid_t run = campaign.start();
  ASSERT_TRUE(eventually([&] { return campaign.has_checkpoint(1); })) << campaign.program.messages();
  const std::string job = campaign.job_of(1, 1);
  std::string node = run_and_capture({"squeue", "-h", "-j", job, "-o", "%N"}).out;
  node.erase(node.find_last_not_of('\n') + 1);
  ASSERT_THAT(node, ::testing::StartsWith("n")) << run_and_capture({"squeue", "-t", "all"}).out;
  const std::vector<pid_t> first_copy = campaign.program.jobs();
  ASSERT_EQ(first_copy.size(), 1U);
  // Frozen until Slurm has noticed (about 30 s), or it would have finished by then.
  ::kill(first_copy[0], SIGSTOP);
  sandbox.call({"kill-node", node});
  const bool has_second = eventually([&] { return std::filesystem::exists(campaign.attempt(1, 2) / "started.json"); });
  ::kill(first_copy[0], SIGCONT);
  ASSERT_TRUE(has_second) << campaign.program.messages() << campaign.report();
  EXPECT_EQ(campaign.job_of(1, 2), job) << "not the same job started twice\n"
                                        << campaign.program.messages() << campaign.report();

  EXPECT_EQ(CampaignProgram::wait_for(run), 0) << campaign.program.messages() << campaign.report();
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(campaign.attempt(1, 1) / "status"); }));
  EXPECT_THAT(content_of(campaign.attempt(1, 1) / "exit.json"), HasSubstr("\"code\": 76"))
      << content_of(campaign.attempt(1, 1) / "status") << content_of(campaign.attempt(1, 1) / "stderr")
      << content_of(campaign.attempt(1, 1) / "job.log");
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_TRUE(eventually([&] { return campaign.program.jobs().empty(); }));
  expect_local_outcome(campaign, "5");
}

}  // namespace
}  // namespace rouleau::campaign
