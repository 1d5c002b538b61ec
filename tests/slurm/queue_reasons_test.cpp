// SPDX-License-Identifier: BSD-3-Clause
// Why a queued job does not start: waited for, held, or never going to start. Each is named, and each has its move.
#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::FakeCampaign;
using ::testing::AnyOf;
using ::testing::HasSubstr;

struct Reason {
  const char* reason;
  const char* words;
};

std::string name_of(const ::testing::TestParamInfo<Reason>& test) {
  std::string name = test.param.reason;
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return name;
}

/// A job that waits with this reason from its release on.
void queue(const FakeCampaign& campaign, const char* reason) {
  campaign.slurm.set("pending_reason", reason);
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_EQ(campaign.slurm.living().size(), 1U);
  ASSERT_EQ(campaign.slurm.living()[0].reason, reason);
}

/// What the administrator, or time, changes.
void let_go(const FakeCampaign& campaign) {
  campaign.slurm.unset("pending_reason");
  campaign.slurm.control({"pend", campaign.slurm.jobs().at(0).id, "None"});
}

class Waiting : public ::testing::TestWithParam<Reason> {};

TEST_P(Waiting, IsShownAndWaitedFor) {
  const FakeCampaign campaign;
  queue(campaign, GetParam().reason);
  for (int pass = 0; pass < 2; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_THAT(campaign.status_text(), HasSubstr(GetParam().words));
  EXPECT_THAT(campaign.status_text(), HasSubstr(GetParam().reason));
  let_go(campaign);
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

// Resources, Priority and BeginTime end by themselves, here too, so they are not among these.
INSTANTIATE_TEST_SUITE_P(Reasons, Waiting,
                         ::testing::Values(Reason{"QOSMaxJobsPerUserLimit", "queued"},
                                           Reason{"AssocGrpCpuLimit", "queued"},
                                           Reason{"ReqNodeNotAvail, UnavailableNodes:n[1-2]", "queued"},
                                           Reason{"Licenses", "queued"}, Reason{"SomethingNew", "queued"},
                                           Reason{"JobHeldAdmin", "held"}),
                         name_of);

class Impossible : public ::testing::TestWithParam<Reason> {};

TEST_P(Impossible, IsCancelledAndThePointRefusedUntilRetried) {
  const FakeCampaign campaign;
  queue(campaign, GetParam().reason);
  ASSERT_TRUE(campaign.sync_until([&] { return is_final(campaign.program.state(1)); })) << campaign.last_words();
  EXPECT_EQ(campaign.program.state(1), State::refused);
  EXPECT_THAT(campaign.why(1), HasSubstr(GetParam().reason));
  EXPECT_THAT(campaign.why(1), HasSubstr("cluster.ini"));
  EXPECT_TRUE(campaign.slurm.living().empty()) << "the job that can never start waits still";

  campaign.slurm.unset("pending_reason");
  ASSERT_EQ(campaign.program.rouleau({"retry", "#1", "-C", "c"}).status, 0);
  EXPECT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

INSTANTIATE_TEST_SUITE_P(Reasons, Impossible,
                         ::testing::Values(Reason{"PartitionConfig", ""}, Reason{"PartitionTimeLimit", ""},
                                           Reason{"PartitionNodeLimit", ""}, Reason{"BadConstraints", ""},
                                           Reason{"DependencyNeverSatisfied", ""}, Reason{"InvalidAccount", ""},
                                           Reason{"QOSMaxWallDurationPerJobLimit", ""}),
                         name_of);

TEST(HeldJob, ThatItsOwnerHoldsIsNotReleasedAgain) {
  const FakeCampaign campaign;
  campaign.slurm.set("pending_reason", "Licenses");
  for (int pass = 0; pass < 2; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  const std::string id = campaign.slurm.jobs().at(0).id;
  campaign.slurm.control({"pend", id, "JobHeldUser"});
  const int releases = campaign.slurm.calls("scontrol");
  for (int pass = 0; pass < 3; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.slurm.calls("scontrol"), releases) << "the user's hold was lifted";
  EXPECT_THAT(campaign.status_text(), HasSubstr("held"));
  let_go(campaign);
  EXPECT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

TEST(HeldJob, WhoseReleaseTheControllerForgotIsReleasedAgain) {
  // Measured: a controller that was killed came back with a job that had run for seconds as PENDING, JobHeldUser.
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  campaign.slurm.control({"requeue", campaign.slurm.jobs().at(0).id, "kill", "JobHeldUser"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

TEST(HeldJob, AfterAFailedLaunchIsReplaced) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  const std::string id = campaign.slurm.jobs().at(0).id;
  campaign.slurm.control({"requeue", id, "kill", "launch failed requeued held"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_THAT(campaign.why(1), HasSubstr("launch"));
  EXPECT_EQ(campaign.slurm.jobs().size(), 2U);
  // The point is done when its solver says so; the second job's script ends a moment later.
  EXPECT_TRUE(rouleau::testing::eventually([&] { return campaign.slurm.living().empty(); })) << "a job is left over";
}

TEST(HeldJob, AfterAFailedLaunchWhoseFirstCopyLivesIsFencedOff) {
  const FakeCampaign campaign;
  rouleau::testing::CampaignProgram::set_speed(20000, 20);  // 2 s
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_TRUE(rouleau::testing::eventually(
      [&] { return std::filesystem::exists(campaign.program.run_directory(1) / "checkpoints/000000000020.h5"); }));
  rouleau::testing::CampaignProgram::set_speed(100, 50);
  campaign.slurm.control({"requeue", campaign.slurm.jobs().at(0).id, "spare", "launch failed requeued held"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_TRUE(rouleau::testing::eventually([&] { return campaign.program.jobs().empty(); }));
  EXPECT_THAT(rouleau::testing::content_of(campaign.program.run_directory(1) / "attempts/1/status"), AnyOf("76\n", ""))
      << "the first copy went on beside the second";
  EXPECT_EQ(campaign.program.rouleau({"verify", "c"}).status, 0);
}

}  // namespace
}  // namespace rouleau::campaign
