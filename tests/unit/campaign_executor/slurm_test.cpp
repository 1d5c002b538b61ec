// SPDX-License-Identifier: BSD-3-Clause
// Slurm's programs, played by scripts on the PATH: what their answers, errors and silences become.
#include "executor/slurm.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A PATH that begins with programs of the test's own.
class SlurmPrograms : public ::testing::Test {
 protected:
  SlurmPrograms() : before_(::getenv("PATH")) { ::setenv("PATH", (place_.path().string() + ":" + before_).c_str(), 1); }
  ~SlurmPrograms() override { ::setenv("PATH", before_.c_str(), 1); }

  /// Installs a program that notes its arguments and then does `code`.
  void install(const std::string& name, const std::string& code) {
    const std::filesystem::path file = place_.path() / name;
    rouleau::testing::set_content(
        file, "#!/bin/bash\nprintf '<%s>' \"$@\" >" + (place_.path() / "arguments").string() + "\n" + code + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  [[nodiscard]] std::string arguments() const { return rouleau::testing::content_of(place_.path() / "arguments"); }

  rouleau::testing::TemporaryDirectory place_;
  Slurm slurm_{60};

 private:
  std::string before_;
};

TEST_F(SlurmPrograms, QueueIsAskedOnceForAllJobsOfThisUser) {
  install("squeue", "echo '12|rouleau-a|RUNNING|n1|None'; echo '13|x|PENDING||Priority'");
  const JobList jobs = slurm_.jobs();
  ASSERT_TRUE(jobs.answered);
  ASSERT_THAT(jobs.rows, SizeIs(2));
  EXPECT_EQ(jobs.rows[0].id, "12");
  EXPECT_EQ(jobs.rows[0].name, "rouleau-a");
  EXPECT_EQ(jobs.rows[0].state, "RUNNING");
  EXPECT_EQ(jobs.rows[0].nodes, "n1");
  EXPECT_EQ(jobs.rows[1].nodes, "");
  EXPECT_EQ(jobs.rows[1].reason, "Priority");
  EXPECT_EQ(arguments(), "<-h><-u><" + std::to_string(::getuid()) + "><-t><all><-o><%i|%j|%T|%N|%r>");
}

TEST_F(SlurmPrograms, EmptyQueueIsAnAnswerAndAnErrorIsNone) {
  install("squeue", "exit 0");
  EXPECT_TRUE(slurm_.jobs().answered);
  install("squeue", "echo '12|rouleau-a|RUNNING|n1|None'; echo 'slurm_load_jobs error: Unable to contact' >&2; exit 1");
  const JobList jobs = slurm_.jobs();
  EXPECT_FALSE(jobs.answered);
  EXPECT_TRUE(jobs.rows.empty());  // half an answer would look like vanished jobs
  EXPECT_THAT(jobs.trouble, HasSubstr("squeue ended with status 1: slurm_load_jobs error: Unable to contact"));
}

TEST_F(SlurmPrograms, QueueThatHangsIsGivenUp) {
  install("squeue", "echo waiting >&2; sleep 100");
  const JobList jobs = Slurm(0.3).jobs();
  EXPECT_FALSE(jobs.answered);
  EXPECT_THAT(jobs.trouble, HasSubstr("squeue gave no answer within 0.3 s"));
  EXPECT_THAT(jobs.trouble, HasSubstr("waiting"));
}

TEST_F(SlurmPrograms, MissingProgramIsATroubleNotAnException) {
  ::setenv("PATH", place_.path().c_str(), 1);
  const JobList jobs = slurm_.jobs();
  EXPECT_FALSE(jobs.answered);
  EXPECT_THAT(jobs.trouble, HasSubstr("cannot start squeue"));
  const Submission submission = slurm_.submit_held("job.sh");
  EXPECT_EQ(submission.id, "");
  EXPECT_TRUE(submission.transient);
  EXPECT_THAT(slurm_.cancel("1"), HasSubstr("cannot start scancel"));
}

TEST_F(SlurmPrograms, SubmissionIsHeldAndItsNumberFoundAmongASitesWords) {
  install("sbatch", "echo 'Welcome to 2026'; echo '4711;cluster'; echo 'charged 3 credits'; echo 'be nice' >&2");
  const Submission submission = slurm_.submit_held("/a b/job $(x).sh");
  EXPECT_EQ(submission.id, "4711");
  EXPECT_EQ(submission.trouble, "");
  EXPECT_EQ(submission.words, "be nice");
  EXPECT_EQ(arguments(), "<--parsable><--hold></a b/job $(x).sh>");
}

TEST_F(SlurmPrograms, SubmissionWithoutANumberMayHaveHappened) {
  install("sbatch", "echo 'Submitted batch job'");
  const Submission submission = slurm_.submit_held("job.sh");
  EXPECT_EQ(submission.id, "");
  EXPECT_TRUE(submission.transient);
  EXPECT_THAT(submission.trouble, HasSubstr("Submitted batch job"));
}

TEST_F(SlurmPrograms, SubmissionThatHangsIsTransient) {
  install("sbatch", "echo 12; sleep 100");
  const Submission submission = Slurm(0.3).submit_held("job.sh");
  EXPECT_EQ(submission.id, "");
  EXPECT_TRUE(submission.transient);
  EXPECT_THAT(submission.trouble, HasSubstr("no answer within 0.3 s"));
}

TEST_F(SlurmPrograms, RefusalIsToldInSlurmsWordsOnOneLine) {
  install("sbatch",
          "echo 'sbatch: error: invalid partition specified: x' >&2; "
          "echo 'sbatch: error: Batch job submission failed: Invalid partition name specified' >&2; exit 1");
  const Submission submission = slurm_.submit_held("job.sh");
  EXPECT_FALSE(submission.transient);
  EXPECT_THAT(submission.trouble, HasSubstr("invalid partition specified: x; sbatch: error: Batch job"));
  EXPECT_EQ(submission.trouble.find('\n'), std::string::npos);
}

TEST_F(SlurmPrograms, ClientsDoNotInheritTheJobThatWeAreIn) {
  ::setenv("SLURM_NTASKS", "48", 1);
  install("sbatch", "echo ${SLURM_NTASKS:-5}");
  EXPECT_EQ(slurm_.submit_held("job.sh").id, "5");
  ::unsetenv("SLURM_NTASKS");
}

TEST_F(SlurmPrograms, TestSubmitsNothingAndTellsWhenTheJobWouldStart) {
  install("sbatch", "echo 'sbatch: Job 12 to start at 2026-01-01T00:00:00 using 1 processors on nodes n1' >&2");
  const Submission answer = slurm_.test_only("job.sh");
  EXPECT_EQ(answer.id, "12");
  EXPECT_THAT(answer.words, HasSubstr("to start at 2026"));
  EXPECT_EQ(arguments(), "<--test-only><job.sh>");
  install("sbatch", "echo 'allocation failure: Requested node configuration is not available' >&2; exit 1");
  EXPECT_EQ(slurm_.test_only("job.sh").id, "");
  EXPECT_FALSE(slurm_.test_only("job.sh").transient);
}

TEST_F(SlurmPrograms, ReleaseAndCancelOfAJobThatIsGoneAreDone) {
  install("scontrol", "exit 0");
  EXPECT_EQ(slurm_.release("12"), "");
  EXPECT_EQ(arguments(), "<release><12>");
  install("scontrol", "echo 'Job is no longer pending execution for job 12' >&2; exit 1");
  EXPECT_EQ(slurm_.release("12"), "");
  install("scontrol", "echo 'Job has already finished for job 12' >&2; exit 1");
  EXPECT_EQ(slurm_.release("12"), "");
  install("scontrol", "echo 'Unable to contact slurm controller (connect failure)' >&2; exit 1");
  EXPECT_THAT(slurm_.release("12"), HasSubstr("Unable to contact"));
  install("scancel", "exit 0");
  EXPECT_EQ(slurm_.cancel("12"), "");
  EXPECT_EQ(arguments(), "<12>");
  install("scancel", "echo 'scancel: error: Kill job error on job id 12: Invalid job id specified' >&2; exit 1");
  EXPECT_EQ(slurm_.cancel("12"), "");
  install("scancel", "echo 'scancel: error: Kill job error: Job/step already completing or completed' >&2; exit 1");
  EXPECT_EQ(slurm_.cancel("12"), "");
  install("scancel", "echo 'scancel: error: Kill job error on job id 12: Access/permission denied' >&2; exit 1");
  EXPECT_THAT(slurm_.cancel("12"), HasSubstr("permission denied"));
}

TEST(SlurmRows, ReasonMayHoldAnything) {
  const auto rows = parse_job_rows(
      "1|a|PENDING||ReqNodeNotAvail, UnavailableNodes:n[1-2]\n"
      "2|b|PENDING||a | b || c\n"
      "3|c|PENDING||Nodes required for job are DOWN, DRAINED or reserved\n"
      "4|d|RUNNING|n[1-3,7]|\n"
      "5|e|PENDING||(launch failed requeued held)  \r\n");
  ASSERT_THAT(rows, SizeIs(5));
  EXPECT_EQ(rows[0].reason, "ReqNodeNotAvail, UnavailableNodes:n[1-2]");
  EXPECT_EQ(rows[1].reason, "a | b || c");
  EXPECT_EQ(rows[3].nodes, "n[1-3,7]");
  EXPECT_EQ(rows[3].reason, "");
  EXPECT_EQ(rows[4].reason, "(launch failed requeued held)");
}

TEST(SlurmRows, LinesThatAreNoRowsAreLeftOut) {
  const auto rows = parse_job_rows(
      "squeue: the queue is long "
      "today\n\n|||||\nx|y|z|w|v\n12|a|RUNNING\n7_[2-3%2]|array|PENDING||Resources\n8|b|RUNNING|n1|None");
  ASSERT_THAT(rows, SizeIs(2));
  EXPECT_EQ(rows[0].id, "7_[2-3%2]");
  EXPECT_EQ(rows[1].id, "8");
  EXPECT_TRUE(parse_job_rows("").empty());
}

TEST(SlurmJobId, IsTheLastLineThatIsANumber) {
  EXPECT_EQ(parse_job_id("12\n"), "12");
  EXPECT_EQ(parse_job_id("12"), "12");
  EXPECT_EQ(parse_job_id("12;cluster\n"), "12");
  EXPECT_EQ(parse_job_id("sbatch: lua: 3 hints\n7\n12\n\nThank you for 5 years\n"), "12");
  EXPECT_EQ(parse_job_id("  12 \r\n"), "12");
  for (const char* wrong :
       {"", "\n", "job 12", "12 13", "-12", "12;", "12;a b", "0x12", "12_1", "Submitted batch job 12"}) {
    EXPECT_EQ(parse_job_id(wrong), "") << wrong;
  }
}

TEST(SlurmErrors, StatesThatPassAreToldFromRefusals) {
  // Texts of Slurm 22.05's library and tools.
  for (const char* passes :
       {"sbatch: error: Batch job submission failed: Unable to contact slurm controller (connect failure)",
        "slurm_load_jobs error: Unable to contact slurm controller (connect failure)",
        "sbatch: error: Batch job submission failed: Protocol authentication error",
        "sbatch: error: If munged is up, restart with --num-threads=10",
        "sbatch: error: Munge encode failed: Failed to access \"/run/munge/munge.socket.2\": No such file or directory",
        "sbatch: error: Batch job submission failed: Invalid authentication credential",
        "sbatch: error: Batch job submission failed: Socket timed out on send/recv operation",
        "sbatch: error: Batch job submission failed: Zero Bytes were transmitted or received",
        "sbatch: error: Slurm temporarily unable to accept job, sleeping and retrying",
        "sbatch: error: Batch job submission failed: Resource temporarily unavailable",
        "slurm_submit_batch_job: Slurm backup controller in standby mode",
        "sbatch: error: Batch job submission failed: Controller is in standby mode, try a different controller",
        "sbatch: error: Batch job submission failed: I/O error writing script/environment to file",
        "sbatch: error: AssocMaxSubmitJobLimit\nsbatch: error: Batch job submission failed: Job violates "
        "accounting/QOS policy (job submit limit, user's size and/or time limits)",
        "sbatch: error: QOSMaxSubmitJobPerUserLimit", "sbatch: error: AssocGrpSubmitJobsLimit",
        "sbatch: error: Batch job submission failed: Required partition not available (inactive or drain)",
        "sbatch: error: Batch job submission failed: Required node not available (down, drained or reserved)",
        "sbatch: error: resolve_ctls_from_dns_srv: res_nsearch error: Unknown host\nsbatch: error: fetch_config: DNS "
        "SRV "
        "lookup failed\nsbatch: fatal: Could not establish a configuration source"}) {
    EXPECT_TRUE(is_transient(passes)) << passes;
  }
  for (const char* refused :
       {"sbatch: error: Batch job submission failed: Invalid partition name specified",
        "sbatch: error: Batch job submission failed: Invalid account or account/partition combination specified",
        "sbatch: error: Batch job submission failed: Invalid qos specification",
        "sbatch: error: Batch job submission failed: Requested time limit is invalid (missing or exceeds some limit)",
        "sbatch: error: Batch job submission failed: Requested node configuration is not available",
        "sbatch: error: Batch job submission failed: Invalid feature specification",
        "sbatch: error: AssocMaxWallDurationPerJobLimit\nsbatch: error: Batch job submission failed: Job violates "
        "accounting/QOS policy (job submit limit, user's size and/or time limits)",
        "sbatch: error: Batch job submission failed: Access/permission denied", "sbatch: unrecognized option '--nix'",
        "sbatch: error: Unable to open file job.sh", "sbatch: error: Invalid directive found in batch script: x", ""}) {
    EXPECT_FALSE(is_transient(refused)) << refused;
  }
}

TEST(SlurmRestarts, AreTheLastLineThatIsANumber) {
  EXPECT_EQ(parse_restarts("0                   \n"), 0);
  EXPECT_EQ(parse_restarts("Welcome\n  3  \n"), 3);
  for (const char* text : {"", "\n", "N/A\n", "-1\n", "3 4\n", "99999999999999999999\n"})
    EXPECT_EQ(parse_restarts(text), std::nullopt) << text;
}

}  // namespace
}  // namespace rouleau::campaign
