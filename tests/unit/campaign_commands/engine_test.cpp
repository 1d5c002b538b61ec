// SPDX-License-Identifier: BSD-3-Clause
// `rouleau engine`: each check's line, advice and exit code, against a fake Slurm.
#include <gmock/gmock.h>
#include <signal.h>

#include "commands/engine_trial.hpp"
#include "support/campaign_program.hpp"
#include "support/slurm/fake_slurm.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::FakeSlurm;
using rouleau::testing::set_content;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class EngineVerb : public ::testing::Test {
 protected:
  EngineVerb() { write_cluster(""); }

  void write_cluster(const std::string& more) const {
    set_content(program_.path() / "cluster.ini", "time_limit = 10\n" + more);
  }
  [[nodiscard]] Capture check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"engine", "check"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.rouleau(words);
  }
  /// A solver that does this.
  void use_solver(const std::string& code) const {
    const std::filesystem::path file = program_.path() / "solver";
    set_content(file, "#!/bin/sh\n" + code);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    ::setenv("ROULEAU_SOLVER", file.c_str(), 1);
  }
  /// Neither in the queue nor on the disk.
  void expect_nothing_left() const {
    EXPECT_TRUE(eventually([&] { return slurm_.living().empty(); }));
    for (const auto& entry : std::filesystem::directory_iterator(program_.path())) {
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("rouleau-check")));
    }
  }

  CampaignProgram program_;
  FakeSlurm slurm_;
};

TEST_F(EngineVerb, ListNamesTheEngines) {
  const Capture capture = program_.rouleau({"engine", "list"});
  EXPECT_EQ(capture.status, 0);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("local "), HasSubstr("slurm ")));
}

TEST_F(EngineVerb, WrongWordsAreUsageErrors) {
  EXPECT_EQ(program_.rouleau({"engine"}).status, 2);
  EXPECT_THAT(program_.rouleau({"engine", "chek"}).err, HasSubstr("Did you mean `check`?"));
  EXPECT_EQ(program_.rouleau({"engine", "list", "check"}).status, 2);
  EXPECT_EQ(check({"--wait-s", "0"}).status, 2);
  EXPECT_EQ(check({"--cluster", "nowhere.ini"}).status, 3);
  std::filesystem::remove(program_.path() / "cluster.ini");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("has no cluster.ini. Name a cluster file by --cluster FILE"));
}

TEST_F(EngineVerb, HelpOfTheClusterFileIsPrinted) {
  const Capture capture = program_.rouleau({"engine", "--help-cluster"});
  EXPECT_EQ(capture.status, 0);
  EXPECT_THAT(capture.out, HasSubstr("points_per_job"));
}

TEST_F(EngineVerb, JobThatRunsOnTwoRanksIsAllThatIsNeeded) {
  use_solver("echo '{\"contract\": 1, \"code\": 0, \"reason\": \"end\", \"ranks\": 2}' >attempts/1/exit.json\n");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 0);
  for (const char* line : {"ok       sbatch           slurm-wlm", "ok       controller       answers",
                           "ok       request", "ok       shared directory", "ok       clock            that of ",
                           "ok       MPI              rouleau-solver ran on 2 ranks by srun --mpi=pmix"}) {
    EXPECT_THAT(capture.out, HasSubstr(line));
  }
  EXPECT_EQ(slurm_.jobs().size(), 1u);
  expect_nothing_left();
}

TEST_F(EngineVerb, RanksThatDoNotFindEachOtherAreFound) {
  use_solver("echo '{\"contract\": 1, \"code\": 0, \"reason\": \"end\", \"ranks\": 1}' >attempts/1/exit.json\n");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, HasSubstr("FAILED   MPI              of two ranks by srun --mpi=pmix, each ran alone."));
}

TEST_F(EngineVerb, NoJobIsSubmittedWhenNoneIsWanted) {
  const Capture capture = check({"--no-job"});
  EXPECT_EQ(capture.status, 0) << capture.out;
  EXPECT_TRUE(slurm_.jobs().empty());
}

TEST_F(EngineVerb, RefusedRequestIsToldInSlurmsWordsAndNothingIsSubmitted) {
  slurm_.set("refuse_test", "allocation failure: Requested node configuration is not available");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("FAILED   request"), HasSubstr("Requested node configuration"),
                                 HasSubstr("Correct partition")));
  EXPECT_TRUE(slurm_.jobs().empty());
}

TEST_F(EngineVerb, SilentControllerIsExitCodeSix) {
  slurm_.set("down", "0");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 6);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("FAILED   controller"), HasSubstr("Try again later")));
}

TEST_F(EngineVerb, MissingProgramsAreNamed) {
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Capture capture = check();
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("FAILED   sbatch"), HasSubstr("Load Slurm's module")));
}

TEST_F(EngineVerb, JobThatCanNeverStartIsCancelledAtOnce) {
  slurm_.set("pending_reason", "PartitionConfig");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("FAILED   job"), HasSubstr("can never start"), HasSubstr("cancelled")));
  expect_nothing_left();
}

TEST_F(EngineVerb, JobThatDoesNotStartInTimeIsCancelled) {
  slurm_.set("pending_reason", "ReqNodeNotAvail");
  const Capture capture = check({"--wait-s", "3"});
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("was not at its end after 3 s: queued (waits for nodes that are down"),
                                 HasSubstr("--wait-s")));
  expect_nothing_left();
}

TEST_F(EngineVerb, InterruptCancelsTheJob) {
  slurm_.set("pending_reason", "ReqNodeNotAvail");
  const pid_t pid = program_.start({"engine", "check"});
  ASSERT_TRUE(eventually([&] { return program_.messages().find("was submitted") != std::string::npos; }));
  ::kill(pid, SIGINT);
  EXPECT_EQ(CampaignProgram::wait_for(pid), 130);
  expect_nothing_left();
}

TEST_F(EngineVerb, SolverThatFailsIsQuotedWithAdvice) {
  use_solver("echo 'libmpi.so.40: cannot open shared object' >&2\nexit 127\n");
  const Capture capture = check();
  EXPECT_EQ(capture.status, 1);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("FAILED   MPI"), HasSubstr("libmpi.so.40: cannot open shared object"),
                                 HasSubstr("setup line")));
  expect_nothing_left();
}

TEST(EngineTrial, ScriptIsSmallAndGreetsBeforeTheSolverStarts) {
  Cluster cluster;
  cluster.time_limit_s = 86400;
  cluster.partition = "batch";
  cluster.points_per_job = 48;
  cluster.nodes = 4;
  cluster.setup = {"module load mpi"};
  const std::string text = trial_script(cluster, "/bin/solver", "/data/a b", "12ab");
  for (const char* part :
       {"--job-name=rouleau-check-12ab\n", "--time=0-00:02:00\n", "--nodes=1\n", "--ntasks=2\n", "--partition=batch\n",
        "--no-requeue\n", "module load mpi\ncd '/data/a b'\nhostname >node.tmp"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, Not(HasSubstr("--signal")));
}

}  // namespace
}  // namespace rouleau::campaign
