// SPDX-License-Identifier: BSD-3-Clause
// The test's own Slurm: it runs jobs, listens on loopback alone, and leaves nothing behind; and the fake Slurm says
// what it says.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "support/campaign_program.hpp"
#include "support/slurm/fake_slurm.hpp"
#include "support/slurm/slurm_sandbox.hpp"

namespace rouleau::testing {
namespace {

using rouleau::campaign::Capture;
using rouleau::campaign::run_and_capture;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(Sandbox, RunsJobsAndListensOnLoopbackAlone) {
  const SlurmSandbox sandbox;
  const Capture job = run_and_capture({"sbatch", "--parsable", "-t", "5", "-n", "2", "-D", sandbox.directory().string(),
                                       "--wrap", "touch began; srun --mpi=pmix -n 2 sleep 60"});
  ASSERT_EQ(job.status, 0) << job.err;
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(sandbox.directory() / "began"); }));
  ASSERT_TRUE(eventually([&] { return sandbox.lines_of({"listeners"}).size() > 5; })) << "srun listens nowhere?";
  for (const std::string& listener : sandbox.lines_of({"listeners"})) {
    EXPECT_THAT(listener, AnyOf(StartsWith("127."), StartsWith("[::1]")));
  }
}

TEST(Sandbox, LeavesNoProcessBehind) {
  std::string directory;
  {
    const SlurmSandbox sandbox;
    directory = sandbox.directory();
    const Capture job = run_and_capture({"sbatch", "-t", "5", "-D", directory, "--wrap", "touch began; sleep 600"});
    ASSERT_EQ(job.status, 0) << job.err;
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(sandbox.directory() / "began"); }));
    EXPECT_GT(sandbox.lines_of({"processes"}).size(), 5U);
  }
  EXPECT_THAT(run_and_capture({SLURM_SANDBOX_PROGRAM, "processes", directory}).out, IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(directory));
}

TEST(Sandbox, LeavesNoProcessBehindWhenItsOwnerIsKilled) {
  std::string pattern = "/tmp/rouleau-slurm-XXXXXX";
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  const pid_t owner = ::fork();
  if (owner == 0) {
    const Capture started = run_and_capture({SLURM_SANDBOX_PROGRAM, "start", pattern, std::to_string(::getpid())});
    if (started.status != 0) ::_exit(1);
    ::setenv("SLURM_CONF", (pattern + "/slurm.conf").c_str(), 1);
    const Capture job = run_and_capture({"sbatch", "-t", "5", "-D", pattern, "--wrap", "sleep 600"});
    ::kill(::getpid(), job.status == 0 ? SIGKILL : SIGTERM);
  }
  int status = 0;
  ::waitpid(owner, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "the sandbox did not start";
  EXPECT_TRUE(eventually([&] { return !std::filesystem::exists(pattern); })) << "nobody cleaned up";
  EXPECT_THAT(run_and_capture({SLURM_SANDBOX_PROGRAM, "processes", pattern}).out, IsEmpty());
}

TEST(Sandbox, ThatCannotStartSaysWhy) {
  try {
    const SlurmSandbox sandbox({"SANDBOX_CPUS=none"});
    ADD_FAILURE() << "it started";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("Slurm did not start"));
    EXPECT_THAT(error.what(), HasSubstr("none")) << "the logs do not say what was wrong";
  }
}

/// What a client answers, without numbers and times: those differ from Slurm to Slurm.
std::string answer_to(const std::vector<std::string>& words) {
  const Capture capture = run_and_capture(words);
  std::string text = fmt::format("{}: {}\n{}\n{}", words[0], capture.status, capture.out, capture.err);
  std::string plain;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    if (is_digit && !plain.empty() && plain.back() == '#') continue;
    plain += is_digit ? '#' : c;
  }
  return plain;
}

std::vector<std::string> all_answers(const std::string& script) {
  std::vector<std::string> answers;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"sbatch", "--parsable", "--hold", "-J", "rouleau-1", "-t", "5", script},
           {"squeue", "-h", "-t", "all", "-n", "rouleau-1", "-o", "%i|%j|%T|%N|%r|%L"},
           {"sbatch", "--test-only", "-p", "short", script},
           {"sbatch", "-p", "nosuch", script},
           {"sbatch", "--test-only", "-p", "nosuch", script},
           {"sbatch", "--test-only", "-n", "64", script},
           {"sbatch", "--test-only", "-N", "3", script},
           {"sbatch", "-t", "abc", script},
           {"sbatch", "--nosuch", script},
           {"sbatch", "/nonexistent/script"},
           {"squeue", "-h", "-j", "9999", "-o", "%T"},
           {"scontrol", "release", "9999"},
           {"scontrol", "release", "1"},
           {"scancel", "9999"},
           {"scancel", "1"},
           {"squeue", "-h", "-t", "all", "-n", "rouleau-1", "-o", "%i|%j|%T|%N|%r"},
           {"scontrol", "release", "1"},
           {"scontrol", "show", "job", "9999"},
           {"scontrol", "show", "partition", "nosuch"},
           {"sacct"}}) {
    answers.push_back(answer_to(words));
    if (words == std::vector<std::string>{"scontrol", "release", "1"}) {
      std::this_thread::sleep_for(std::chrono::seconds(3));  // to be started
    }
    if (words[0] == "scancel") std::this_thread::sleep_for(std::chrono::seconds(2));
  }
  return answers;
}

TEST(FakeSlurmPrograms, SayWhatTheRealOnesSay) {
  const TemporaryDirectory place;
  const std::string script = place.path() / "job.sh";
  set_content(script, "#!/bin/bash\n#SBATCH --output=/dev/null\nexec sleep 60\n");
  std::vector<std::string> real, fake;
  {
    const SlurmSandbox sandbox;
    real = all_answers(script);
  }
  {
    const FakeSlurm slurm;
    fake = all_answers(script);
  }
  for (std::size_t i = 0; i < real.size(); ++i) EXPECT_EQ(fake[i], real[i]);
}

}  // namespace
}  // namespace rouleau::testing
