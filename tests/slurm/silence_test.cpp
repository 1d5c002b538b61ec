// SPDX-License-Identifier: BSD-3-Clause
// Slurm that does not answer, answers late, or has forgotten: nothing is concluded from that.
#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::FakeCampaign;
using ::testing::HasSubstr;

constexpr int engine_unreachable = 6;

struct Outage {
  const char* setting;
  const char* seconds;
  const char* words;
};

class OutageOf : public ::testing::TestWithParam<Outage> {};

TEST_P(OutageOf, SlurmChangesNothing) {
  const FakeCampaign campaign("4, 5", "client_timeout_s = 1.5\njobs = 1\n");
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  ASSERT_EQ(campaign.sync().status, 0);
  const auto before = campaign.program.store().points();
  campaign.slurm.set(GetParam().setting, GetParam().seconds);
  for (int pass = 0; pass < 2; ++pass) {
    const auto capture = campaign.sync();
    EXPECT_EQ(capture.status, engine_unreachable) << capture.err;
    EXPECT_THAT(capture.err, HasSubstr(GetParam().words));
    EXPECT_EQ(campaign.program.store().points(), before);
  }
  campaign.slurm.unset(GetParam().setting);
  // It ran on meanwhile, and ends now.
  rouleau::testing::set_content(campaign.program.run_directory(1) / "stop", "");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_EQ(campaign.slurm.jobs().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, OutageOf,
                         ::testing::Values(Outage{"down", "0", "Unable to contact slurm controller"},
                                           Outage{"munge_down", "0", "Protocol authentication error"},
                                           Outage{"timed_out", "0", "Socket timed out"},
                                           Outage{"down", "30", "gave no answer within 1.5 s"}),
                         [](const auto& test) {
                           std::string name = std::string(test.param.setting) + test.param.seconds;
                           std::erase(name, '_');
                           return name;
                         });

TEST(Silence, WhileTheOnlyJobEndsIsNoReasonToWait) {
  // exit.json is the truth; Slurm is not needed to see that the point is done.
  const FakeCampaign campaign;
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  campaign.slurm.set("down", "0");
  EXPECT_EQ(campaign.sync().status, engine_unreachable);
  EXPECT_EQ(campaign.program.state(1), State::done);
}

TEST(Silence, FromTheStartSubmitsNothingAndClaimsNothing) {
  const FakeCampaign campaign;
  campaign.slurm.set("down", "0");
  EXPECT_EQ(campaign.sync().status, engine_unreachable);
  EXPECT_EQ(campaign.attempts(1), 0);
  EXPECT_EQ(campaign.program.state(1), State::waiting);
  campaign.slurm.unset("down");
  EXPECT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

TEST(Silence, OfRunGoesOnByItself) {
  const FakeCampaign campaign("4, 5, 6");
  campaign.slurm.set("down", "0");
  const pid_t run = campaign.program.start({"run", "c"});
  ASSERT_TRUE(eventually([&] { return campaign.slurm.calls("squeue") > 1; }));
  campaign.slurm.unset("down");
  EXPECT_EQ(CampaignProgram::wait_for(run), 0) << campaign.program.messages();
  EXPECT_EQ(campaign.slurm.jobs().size(), 3U);
}

TEST(ForgottenJob, ThatFinishedIsDone) {
  const FakeCampaign campaign;
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  campaign.slurm.control({"forget", campaign.slurm.jobs().at(0).id});
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.program.state(1), State::done);
  EXPECT_TRUE(campaign.slurm.jobs().empty());
}

TEST(ForgottenJob, IsAliveUntilItsDirectoryWasSilentForLong) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  const std::string id = campaign.slurm.jobs().at(0).id;
  campaign.slurm.control({"end", id, "NODE_FAIL", "kill"});
  campaign.slurm.control({"forget", id});
  for (int pass = 0; pass < 2; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.program.state(1), State::running) << "absence was taken for an end";
  EXPECT_EQ(campaign.slurm.jobs().size(), 0U);

  // Two minutes later, as far as the files can tell; patience_min is 1.
  const std::filesystem::path run = campaign.program.run_directory(1);
  const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::minutes(2);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run)) {
    std::filesystem::last_write_time(entry.path(), long_ago);
  }
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_THAT(campaign.why(1), HasSubstr("does not know job"));
  EXPECT_EQ(campaign.attempts(1), 2);
}

TEST(ForgottenJob, ThatComesBackIsFencedOff) {
  // Given up though it was only slow: its copy, still alive, must notice.
  const FakeCampaign campaign;
  CampaignProgram::set_speed(30000, 20);  // 3 s
  ASSERT_TRUE(campaign.start_and_reach(20));
  CampaignProgram::set_speed(100, 50);
  const std::string id = campaign.slurm.jobs().at(0).id;
  campaign.slurm.control({"end", id, "NODE_FAIL", "spare"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  ASSERT_TRUE(eventually([&] { return campaign.program.jobs().empty(); }));
  EXPECT_THAT(rouleau::testing::content_of(campaign.program.run_directory(1) / "attempts/1/status"), "76\n");
  EXPECT_EQ(campaign.program.rouleau({"verify", "c"}).status, 0);
}

}  // namespace
}  // namespace rouleau::campaign
