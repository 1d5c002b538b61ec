// SPDX-License-Identifier: BSD-3-Clause
// Jobs that Slurm ends, warns, puts back or starts twice, against the outcome of the same study without any of that.
#include "slurm/fake_campaign.hpp"
#include "support/campaign_outcome.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignOutcome;
using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::FakeCampaign;
using rouleau::testing::FakeSlurm;
using rouleau::testing::outcome_of;
using ::testing::HasSubstr;

/// What the same study comes to on this machine, without Slurm.
CampaignOutcome local_outcome(const std::string& lambdas) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = " + lambdas, CampaignProgram::execution());
  EXPECT_EQ(program.init().status, 0);
  EXPECT_EQ(program.run().status, 0);
  return outcome_of(program);
}

void expect_local_outcome(const FakeCampaign& campaign, const std::string& lambdas) {
  const CampaignOutcome expected = local_outcome(lambdas);
  const CampaignOutcome found = outcome_of(campaign.program);
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.results, expected.results);
  EXPECT_EQ(found.logs, expected.logs);
  const auto verified = campaign.program.rouleau({"verify", "c"});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

std::string status_of(const FakeCampaign& campaign, int attempt) {
  return content_of(campaign.program.run_directory(1) / fmt::format("attempts/{}/status", attempt));
}

TEST(TimeLimit, IsMetBehindCheckpointsByAsManyJobsAsItTakes) {
  const FakeCampaign campaign("4, 5");
  campaign.slurm.set("minute_s", "0.95");
  campaign.set_cluster("signal_s = 0\n", 3);  // 2.85 s, of which squeue shows whole seconds
  CampaignProgram::set_speed(60000, 10);      // 6 s a point
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_GE(campaign.attempts(1), 3);
  EXPECT_GE(campaign.attempts(2), 3);
  // A point is done when its solver says so; its script ends a moment later.
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  for (const FakeSlurm::Job& job : campaign.slurm.jobs()) EXPECT_EQ(job.state, "COMPLETED") << job.id;
  CampaignProgram::set_speed(100, 50);
  expect_local_outcome(campaign, "4, 5");
}

TEST(TimeLimit, IsAnnouncedBySignalToASolverThatMissesItsDeadline) {
  const FakeCampaign campaign;
  campaign.slurm.set("minute_s", "1");
  campaign.set_cluster("signal_s = 120\n", 5);
  campaign.script(1, "hang 60\n");  // no deadline ends that, but a signal does
  ASSERT_TRUE(campaign.start_and_reach(50));
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  EXPECT_EQ(status_of(campaign, 1), "75\n");
  EXPECT_EQ(campaign.slurm.jobs()[0].state, "COMPLETED");
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_GE(campaign.program.store().attempts(campaign.program.point(1).key)[1].start_step, 60);
}

TEST(Requeue, GoesOnInAnAttemptOfItsOwn) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  campaign.slurm.set("requeue_delay", "1");
  campaign.slurm.control({"requeue", campaign.slurm.jobs().at(0).id, "kill"});
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.program.state(1), State::running);
  EXPECT_THAT(campaign.status_text(), HasSubstr("BeginTime"));
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U) << "a second job was submitted beside the requeued one";
  EXPECT_EQ(campaign.attempts(1), 2);
  expect_local_outcome(campaign, "5");
}

TEST(Requeue, BesideItsFirstCopyFencesThatOff) {
  const FakeCampaign campaign;
  CampaignProgram::set_speed(30000, 20);  // 3 s
  ASSERT_TRUE(campaign.start_and_reach(20));
  CampaignProgram::set_speed(1000, 20);
  campaign.slurm.control({"fail-node", campaign.slurm.jobs().at(0).node, "spare"});
  EXPECT_EQ(campaign.program.jobs().size(), 1U) << "the first copy is gone: the test proves nothing";
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  ASSERT_TRUE(eventually([&] { return campaign.program.jobs().empty() && !status_of(campaign, 1).empty(); }));
  EXPECT_EQ(status_of(campaign, 1), "76\n");
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  EXPECT_EQ(campaign.attempts(1), 2);
  CampaignProgram::set_speed(100, 50);
  expect_local_outcome(campaign, "5");
}

TEST(Requeue, OfAPackThatIsHalfDoneDoesTheOtherHalf) {
  const FakeCampaign campaign("4, 5", "points_per_job = 2\n");
  campaign.script(2, "hang 60\n");
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_TRUE(eventually([&] {
    return std::filesystem::exists(campaign.program.run_directory(1) / "attempts/1/status") &&
           std::filesystem::exists(campaign.program.run_directory(2) / "checkpoints/000000000050.h5");
  }));
  campaign.slurm.control({"requeue", campaign.slurm.jobs().at(0).id, "kill"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.attempts(1), 1);
  EXPECT_EQ(campaign.attempts(2), 2);
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  expect_local_outcome(campaign, "4, 5");
}

TEST(Requeue, WhoseScriptHasNotClaimedYetIsNotSubmittedTwice) {
  const FakeCampaign campaign("5", "setup = test -z \"$SLURM_RESTART_COUNT\" || sleep 3\n");
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  campaign.slurm.control({"requeue", campaign.slurm.jobs().at(0).id, "kill"});
  // What the script writes when its solver is killed before it is.
  write_whole_file(campaign.program.run_directory(1) / "attempts/1/status", "137\n");
  ASSERT_TRUE(campaign.sync_until([&] { return campaign.slurm.jobs().at(0).state == "RUNNING"; }));
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.program.state(1), State::running);
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.attempts(1), 2);
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);
  expect_local_outcome(campaign, "5");
}

TEST(Requeue, WhoseScriptHasOnlyMadeItsNextFolderIsNotSubmittedTwice) {
  // The script makes the folder first and names its job in it afterwards: a pass may look in between.
  const FakeCampaign campaign;
  campaign.script(1, "hang 50\n");  // with no step after the checkpoint: it would meet the folder and end with 76
  ASSERT_TRUE(campaign.start_and_reach(50));
  const std::filesystem::path claimed = campaign.program.run_directory(1) / "attempts/2";
  ASSERT_TRUE(std::filesystem::create_directory(claimed));
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_EQ(campaign.program.state(1), State::running);
  EXPECT_EQ(campaign.attempts(1), 1) << "a folder that nobody has put his name in was taken for an attempt";
  EXPECT_EQ(campaign.slurm.jobs().size(), 1U);

  // The job has died in between, so that nobody will ever write in it: the point goes on.
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, "NODE_FAIL", "kill"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_EQ(campaign.slurm.jobs().size(), 2U);
  expect_local_outcome(campaign, "5");
}

TEST(FailedNode, WithoutRequeueIsLeftForAnotherJob) {
  const FakeCampaign campaign("5", "requeue = 0\n");
  CampaignProgram::set_speed(30000, 20);
  ASSERT_TRUE(campaign.start_and_reach(20));
  CampaignProgram::set_speed(1000, 20);
  campaign.slurm.control({"fail-node", campaign.slurm.jobs().at(0).node, "spare"});
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  EXPECT_THAT(campaign.why(1), HasSubstr("node failure"));
  ASSERT_TRUE(eventually([&] { return campaign.program.jobs().empty() && !status_of(campaign, 1).empty(); }));
  EXPECT_EQ(status_of(campaign, 1), "76\n");
  CampaignProgram::set_speed(100, 50);
  expect_local_outcome(campaign, "5");
}

TEST(CancelledJob, ByTheUserOfSlurmGoesOnLater) {
  const FakeCampaign campaign;
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  const auto capture = run_and_capture({std::string(FAKE_SLURM_PROGRAMS) + "/scancel", campaign.slurm.jobs().at(0).id});
  ASSERT_EQ(capture.status, 0) << capture.err;
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  expect_local_outcome(campaign, "5");
}

TEST(CancelledPoint, EndsItsJob) {
  const FakeCampaign campaign("4, 5");
  campaign.script(1, "hang 60\n");
  ASSERT_TRUE(campaign.start_and_reach(50));
  ASSERT_EQ(campaign.program.rouleau({"cancel", "#1", "-C", "c"}).status, 0);
  ASSERT_TRUE(campaign.sync_until([&] {
    return campaign.slurm.living().empty() && campaign.program.state(2) == State::done;
  })) << campaign.last_words();
  EXPECT_EQ(campaign.program.state(1), State::cancelled);
  ASSERT_EQ(campaign.program.rouleau({"retry", "#1", "-C", "c"}).status, 0);
  ASSERT_TRUE(campaign.sync_until_all(State::done)) << campaign.last_words();
  expect_local_outcome(campaign, "4, 5");
}

TEST(CancelledPoint, ThatIsQueuedLeavesNoJobThatRuns) {
  const FakeCampaign campaign;
  campaign.slurm.set("pending_reason", "Licenses");
  ASSERT_EQ(campaign.sync().status, 0);
  ASSERT_EQ(campaign.program.rouleau({"cancel", "#1", "-C", "c"}).status, 0);
  for (int pass = 0; pass < 2; ++pass) ASSERT_EQ(campaign.sync().status, 0);
  campaign.slurm.unset("pending_reason");
  for (const FakeSlurm::Job& job : campaign.slurm.living()) campaign.slurm.control({"pend", job.id, "None"});
  ASSERT_TRUE(campaign.sync_until([&] { return campaign.slurm.living().empty(); })) << campaign.last_words();
  EXPECT_EQ(campaign.program.state(1), State::cancelled);
  EXPECT_FALSE(std::filesystem::exists(campaign.program.run_directory(1) / "checkpoints/000000000100.h5"))
      << "it was run to its end";
}

bool are_done(const FakeCampaign& campaign) {
  const std::vector<PointRow> points = campaign.program.store().points();
  return std::all_of(points.begin(), points.end(), [](const PointRow& point) { return point.state == State::done; });
}

TEST(SelfSustaining, GoesOnWithNobodyThere) {
  const FakeCampaign campaign("1:5:1", "jobs = 2\n");
  const auto capture = campaign.program.rouleau({"run", "c", "--engine", "slurm", "--self-sustaining"});
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_TRUE(eventually([&] { return are_done(campaign); })) << campaign.status_text();
  EXPECT_EQ(campaign.slurm.jobs().size(), 5U);
}

TEST(SelfSustaining, IsHowARebuiltCampaignGoesOn) {
  const FakeCampaign campaign("4, 5", "jobs = 1\n");
  campaign.program.write_study("fluid.lambda = 4, 5", CampaignProgram::execution());  // the study says nothing of Slurm
  ASSERT_EQ(campaign.program.init().status, 0);
  campaign.script(1, "hang 60\n");
  ASSERT_EQ(campaign.program.rouleau({"run", "c", "--engine", "slurm", "--self-sustaining"}).status, 0);
  ASSERT_TRUE(eventually(
      [&] { return std::filesystem::exists(campaign.program.run_directory(1) / "checkpoints/000000000050.h5"); }));
  std::filesystem::remove(campaign.program.campaign() / "campaign.db");
  const auto rebuilt = campaign.program.rouleau({"rebuild", "c"});
  ASSERT_EQ(rebuilt.status, 0) << rebuilt.err;
  campaign.slurm.control({"end", campaign.slurm.jobs().at(0).id, "PREEMPTED", "kill"});
  ASSERT_EQ(campaign.sync().status, 0);
  EXPECT_TRUE(eventually([&] { return are_done(campaign); })) << campaign.status_text();
  for (const PointRow& point : campaign.program.store().points()) {
    for (const AttemptRow& attempt : campaign.program.store().attempts(point.key)) EXPECT_EQ(attempt.engine, "slurm");
  }
}

TEST(Migration, ToSlurmAndBackKeepsEveryBit) {
  const FakeCampaign campaign("4, 5");
  campaign.script(1, "crash 60\n");
  campaign.script(2, "-\ncrash 80\n");
  // Local until both have a checkpoint, then Slurm, then local again.
  const auto both_have_begun = [&] {
    return std::filesystem::exists(campaign.program.run_directory(1) / "checkpoints/000000000010.h5") &&
           std::filesystem::exists(campaign.program.run_directory(2) / "checkpoints/000000000010.h5");
  };
  const auto run = [&](const std::string& engine) {
    CampaignProgram::set_speed(20000, 10);  // 2 s a point
    const pid_t manager = campaign.program.start({"run", "c", "--engine", engine});
    const bool is_local = engine == "local";
    EXPECT_TRUE(eventually([&] { return is_local ? both_have_begun() : !campaign.slurm.jobs().empty(); }));
    ::kill(manager, SIGTERM);
    CampaignProgram::wait_for(manager);
  };
  run("local");
  run("slurm");
  CampaignProgram::set_speed(100, 50);
  const auto last = campaign.program.rouleau({"run", "c", "--engine", "local"});
  EXPECT_EQ(last.status, 0) << last.err;
  ASSERT_TRUE(eventually([&] { return campaign.slurm.living().empty(); }));
  ASSERT_EQ(campaign.sync().status, 0);
  std::set<std::string> engines;
  for (const PointRow& point : campaign.program.store().points()) {
    EXPECT_EQ(point.state, State::done);
    for (const AttemptRow& attempt : campaign.program.store().attempts(point.key)) engines.insert(attempt.engine);
  }
  EXPECT_EQ(engines, (std::set<std::string>{"local", "slurm"}));
  expect_local_outcome(campaign, "4, 5");
}

}  // namespace
}  // namespace rouleau::campaign
