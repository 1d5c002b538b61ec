// SPDX-License-Identifier: BSD-3-Clause
// A sweep on a real Slurm to its phase table, by jobs that are far too short for their points, one of them cancelled
// and one put back into the queue: the same database as without Slurm.
#include "slurm/real_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::RealCampaign;
using rouleau::testing::SlurmSandbox;

/// For the jobs' PATH: a squeue that tells a job that it has 4 s left, since Slurm's own limits are whole minutes.
std::string short_of_time(const SlurmSandbox& sandbox) {
  const std::filesystem::path folder = sandbox.directory() / "short";
  std::filesystem::create_directory(folder);
  rouleau::testing::set_content(
      folder / "squeue", "#!/bin/sh\ncase \"$*\" in *%L*) echo 0:04 ;; *) exec /usr/bin/squeue \"$@\" ;; esac\n");
  std::filesystem::permissions(folder / "squeue", std::filesystem::perms(0755));
  return "setup = export PATH=" + folder.string() + ":$PATH\n";
}

TEST(RealSlurm, SweepByShortJobsEndsAsALocalOneDoes) {
  const SlurmSandbox sandbox;
  const std::string lambdas = "1, 5, 8";
  const RealCampaign campaign(lambdas, short_of_time(sandbox));
  const pid_t run = campaign.start();

  ASSERT_TRUE(eventually([&] { return campaign.has_checkpoint(1) && !campaign.job_of(1, 1).empty(); }))
      << campaign.program.messages();
  EXPECT_EQ(run_and_capture({"scancel", campaign.job_of(1, 1)}).status, 0);
  ASSERT_TRUE(eventually([&] { return campaign.has_checkpoint(2) && campaign.attempts(2) >= 1; }));
  const std::string requeued = campaign.job_of(2, campaign.attempts(2));
  const Capture requeue = run_and_capture({"scontrol", "requeue", requeued});
  ::testing::Test::RecordProperty("requeued", requeue.status == 0 ? "yes" : requeue.err);

  EXPECT_EQ(CampaignProgram::wait_for(run), 0) << campaign.program.messages() << campaign.report();
  EXPECT_TRUE(eventually([&] { return run_and_capture({"squeue", "-h"}).out.empty(); })) << "jobs are left over";
  for (int ordinal = 1; ordinal <= 3; ++ordinal) EXPECT_GE(campaign.attempts(ordinal), 3) << campaign.report();
  const Capture table = campaign.program.rouleau({"query", "-C", "c"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_EQ(std::count(table.out.begin(), table.out.end(), '\n'), 4) << table.out;
  expect_local_outcome(campaign, lambdas);
}

}  // namespace
}  // namespace rouleau::campaign
