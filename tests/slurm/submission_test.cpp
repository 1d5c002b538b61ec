// SPDX-License-Identifier: BSD-3-Clause
// What sbatch may answer: an id with noise around it, a refusal, nothing, too late, or for a job that nobody sees yet.
#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::FakeCampaign;
using rouleau::testing::set_content;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Submission, FindsTheIdAmongTheNoiseOfAWrapper) {
  const FakeCampaign campaign;
  campaign.slurm.set("noise_before", "sbatch: lua: queue 12 is cheaper today\nWelcome to the cluster\n2026");
  campaign.slurm.set("noise_after", "cite us: 10.1000/182");
  campaign.slurm.set("cluster", ";north");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_EQ(campaign.program.store().attempts(campaign.program.point(1).key)[0].job_id, "1");
}

TEST(Submission, IsNoLongerWhatStatusSaysOfAJobThatComputes) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50)) << campaign.last_words();
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(campaign.program.run_directory(1) / "progress.json"); }));
  const Capture status = campaign.program.rouleau({"status", "c"});
  EXPECT_THAT(status.out, HasSubstr("job 1"));
  EXPECT_THAT(status.out, Not(HasSubstr("submitted")));
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, "PREEMPTED", "kill"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

struct Refusal {
  const char* name;
  const char* text;  ///< the last line as `Batch job submission failed: ...`
  bool passes;       ///< by itself, when other jobs have ended or the controller is back
};

class RefusalOf : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusalOf, ASubmissionIsNamedAndRepairedByTheNextOne) {
  const FakeCampaign campaign("5", "", "retries = 9\n");
  campaign.slurm.set("refuse", GetParam().text);
  const auto capture = campaign.sync();
  const std::string text = GetParam().text;
  EXPECT_THAT(capture.err, HasSubstr(text.substr(text.rfind('\n') + 1)));
  EXPECT_TRUE(campaign.slurm.jobs().empty());
  campaign.slurm.unset("refuse");
  if (GetParam().passes) {
    // Whether it arrived is not known until a minute has gone: one that arrived late must not find a second.
    ASSERT_EQ(campaign.sync().status, 0);
    EXPECT_EQ(campaign.program.state(1), State::running);
    EXPECT_TRUE(campaign.slurm.jobs().empty());
    campaign.age_submissions();
  }
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, RefusalOf,
    ::testing::Values(
        Refusal{"JobLimit",
                "QOSMaxSubmitJobPerUserLimit\nJob violates accounting/QOS policy (job submit limit, user's size and/or "
                "time limits)",
                true},
        Refusal{"AssociationLimit",
                "AssocMaxSubmitJobLimit\nJob violates accounting/QOS policy (job submit limit, user's size and/or time "
                "limits)",
                true},
        Refusal{"Contact", "Unable to contact slurm controller (connect failure)", true},
        Refusal{"TimedOut", "Socket timed out on send/recv operation", true},
        Refusal{"Account", "Invalid account or account/partition combination specified", false},
        Refusal{"Partition", "invalid partition specified: short\nInvalid partition name specified", false},
        Refusal{"TimeLimit", "Requested time limit is invalid (missing or exceeds some limit)", false},
        Refusal{"Qos", "Invalid qos specification", false},
        Refusal{"Nodes", "Requested node configuration is not available", false},
        Refusal{"Access", "Access/permission denied", false}),
    [](const auto& test) { return test.param.name; });

TEST(Submission, ThatTheTestRefusesClaimsNothing) {
  const FakeCampaign campaign("4, 5", "account = physics\n");
  campaign.slurm.set("accounts", "chemistry");
  const auto capture = campaign.sync();
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("Invalid account or account/partition combination specified"));
  EXPECT_THAT(capture.err, HasSubstr("cluster.ini"));
  EXPECT_EQ(campaign.attempts(1), 0);
  EXPECT_TRUE(campaign.slurm.jobs().empty());
  campaign.slurm.unset("accounts");
  EXPECT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

TEST(Submission, OfMoreThanANodeHasIsRefusedByTheTest) {
  const FakeCampaign campaign("5", "ranks = 64\n");
  const auto capture = campaign.sync();
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("Requested node configuration is not available"));
  EXPECT_EQ(campaign.attempts(1), 0);
}

TEST(Submission, WhoseAnswerIsLostIsFoundByName) {
  const FakeCampaign campaign("5", "client_timeout_s = 1\n");
  campaign.slurm.set("sbatch_sleeps_after", "30");
  const auto capture = campaign.sync();
  EXPECT_THAT(capture.err, HasSubstr("looked for"));
  ASSERT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_EQ(campaign.slurm.jobs()[0].reason, "JobHeldUser");
  campaign.slurm.unset("sbatch_sleeps_after");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_EQ(campaign.attempts(1), 1);
}

TEST(Submission, ThatTheQueueShowsLateIsWaitedFor) {
  const FakeCampaign campaign;
  campaign.slurm.set("invisible", "2");
  ASSERT_EQ(campaign.sync().status, 0);
  for (int pass = 0; pass < 3; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

TEST(Submission, WithoutAnswerThatTheQueueShowsLateIsWaitedFor) {
  const FakeCampaign campaign("5", "client_timeout_s = 1\n");
  campaign.slurm.set("invisible", "3");
  campaign.slurm.set("sbatch_sleeps_after", "30");
  ASSERT_EQ(campaign.sync().status, 0);
  campaign.slurm.unset("sbatch_sleeps_after");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
}

TEST(Submission, IsLimitedInNumberAndRate) {
  const FakeCampaign campaign("1:8:1", "jobs = 5\nsubmissions_per_pass = 3\n");
  campaign.slurm.set("pending_reason", "Licenses");
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.slurm.living().size(), 3U);
  for (int pass = 0; pass < 3; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.slurm.living().size(), 5U);
}

TEST(Submission, OfAPackRunsItsPointsInOneJob) {
  const FakeCampaign campaign("1:5:1", "points_per_job = 2\n");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 3U);
}

TEST(DryRun, PrintsTheScriptsAndDoesNothing) {
  const FakeCampaign campaign("4, 5");
  const auto capture = campaign.program.rouleau({"run", "c", "--dry-run"});
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.out, HasSubstr("#SBATCH --partition=short"));
  EXPECT_TRUE(campaign.slurm.jobs().empty());
  EXPECT_EQ(campaign.attempts(1), 0);
}

TEST(JobScript, SubmittedByHandGoesOnInAnAttemptOfItsOwn) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, "NODE_FAIL", "kill"});
  const std::filesystem::path script = campaign.program.run_directory(1) / "attempts/1/job.sh";
  const auto capture = run_and_capture({std::string(FAKE_SLURM_PROGRAMS) + "/sbatch", script.string()});
  ASSERT_EQ(capture.status, 0) << capture.err;
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 2U);
  EXPECT_EQ(campaign.attempts(1), 2);
}

/// Submits the only point in a job that waits.
void submit_into_a_queue(const FakeCampaign& campaign) {
  campaign.slurm.set("pending_reason", "Licenses");
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_EQ(campaign.slurm.living().size(), 1U);
}

void let_it_start(const FakeCampaign& campaign) {
  campaign.slurm.unset("pending_reason");
  campaign.slurm.control({"pend", campaign.slurm.jobs().at(0).id, "None"});
}

// The run file was looked at when the job was submitted, and never again.
TEST(RunFileOfAWaitingJob, IsNotRunWhenItWasEditedMeanwhile) {
  const FakeCampaign campaign("5", "", "retries = 1\n");
  submit_into_a_queue(campaign);
  const std::filesystem::path run = campaign.program.run_directory(1);
  set_content(run / "run.ini", content_of(run / "run.ini") + "# edited\n");
  let_it_start(campaign);
  ASSERT_TRUE(campaign.sync_until_all(State::exhausted)) << campaign.last_words();
  EXPECT_THAT(campaign.why(1),
              HasSubstr("run.ini is not the file that `rouleau init` wrote; the solver was not start"));
  EXPECT_THAT(campaign.why(1), HasSubstr("`rouleau init STUDY DIR` writes it anew"));
  EXPECT_FALSE(std::filesystem::exists(run / "samples.csv"));
  ASSERT_EQ(campaign.program.init().status, 0);
  ASSERT_EQ(campaign.program.rouleau({"retry", "#1", "-C", "c"}).status, 0);
  EXPECT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
}

TEST(RunFileOfAWaitingJob, IsRunAsTheStudyHasItAtTheStart) {
  const FakeCampaign campaign;
  submit_into_a_queue(campaign);
  campaign.program.write_study("fluid.lambda = 5", CampaignProgram::execution("engine = slurm\n"), "0.02");
  ASSERT_EQ(campaign.program.init().status, 0);
  let_it_start(campaign);
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_EQ(campaign.program.point(1).end_step, 200);
}

}  // namespace
}  // namespace rouleau::campaign
