// SPDX-License-Identifier: BSD-3-Clause
// Running clients that hang, and handing them a clean environment.
#include "executor/capture.hpp"

#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>

#include "executor/process.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::eventually;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Capture within(double seconds, const std::string& code) {
  return run_and_capture({"bash", "-c", code},
                         CaptureSettings{.directory = {}, .time_out_s = seconds, .environment = {}});
}

double seconds_of(const std::function<void()>& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(CampaignTimeOut, ClientInTimeIsAsWithout) {
  const Capture capture = within(60, "echo out; echo err >&2; exit 7");
  EXPECT_FALSE(capture.timed_out);
  EXPECT_EQ(capture.status, 7);
  EXPECT_EQ(capture.out, "out\n");
  EXPECT_EQ(capture.err, "err\n");
}

TEST(CampaignTimeOut, ClientThatHangsIsKilledAndItsWordsAreKept) {
  Capture capture;
  const double seconds = seconds_of([&] { capture = within(0.3, "echo trying; sleep 100"); });
  EXPECT_TRUE(capture.timed_out);
  EXPECT_EQ(capture.status, 128 + SIGKILL);
  EXPECT_EQ(capture.out, "trying\n");
  EXPECT_GE(seconds, 0.3);
  EXPECT_LT(seconds, 30);  // far from the 100 s, on a busy machine too
}

TEST(CampaignTimeOut, WholeGroupIsKilled) {
  const Capture capture = within(0.3, "sleep 100 & echo $!; wait");
  ASSERT_TRUE(capture.timed_out);
  const pid_t grandchild = std::atoi(capture.out.c_str());
  ASSERT_GT(grandchild, 1);
  EXPECT_TRUE(eventually([&] { return !identity_of(grandchild); }));
}

TEST(CampaignTimeOut, ClientThatClosedItsStreamsAndHangsIsKilledToo) {
  EXPECT_TRUE(within(0.3, "exec >/dev/null 2>&1; sleep 100").timed_out);
}

TEST(CampaignTimeOut, ClientThatEndedButLeftAHelperBehindIsNotLate) {
  const Capture capture = within(0.3, "echo 12; sleep 100 & exit 0");
  EXPECT_FALSE(capture.timed_out);
  EXPECT_EQ(capture.status, 0);
  EXPECT_EQ(capture.out, "12\n");
}

TEST(CampaignTimeOut, EndlessWordsAreCutOffByTheClock) { EXPECT_TRUE(within(0.3, "yes").timed_out); }

TEST(CampaignTimeOut, ClientHasNoSignalBlocked) {
  sigset_t blocked, before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &blocked, &before);
  const Capture capture = within(60, "grep SigBlk /proc/self/status");
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_THAT(capture.out, HasSubstr("0000000000000000"));
}

TEST(CampaignEnvironment, SlurmsVariablesAreLeftOutButForWhereAndWho) {
  const std::vector<std::pair<const char*, bool>> variables = {
      {"SLURM_NTASKS", false},    {"SLURM_JOB_ID", false}, {"SBATCH_PARTITION", false},
      {"SQUEUE_FORMAT", false},   {"SRUN_X", false},       {"SALLOC_X", false},
      {"SCANCEL_VERBOSE", false}, {"SLURM_CONFIG", false}, {"SLURM_CONF", true},
      {"SLURM_JWT", true},        {"SLURMX", true},        {"MY_SLURM_NTASKS", true},
  };
  for (const auto& [name, kept] : variables) ::setenv(name, "value", 1);
  const std::vector<std::string> environment = environment_without_slurm();
  const Capture capture =
      run_and_capture({"env"}, CaptureSettings{.directory = {}, .time_out_s = 60, .environment = environment});
  for (const auto& [name, kept] : variables) {
    ::unsetenv(name);
    const std::string line = "\n" + std::string(name) + "=value\n";
    if (kept) {
      EXPECT_THAT("\n" + capture.out, HasSubstr(line));
    } else {
      EXPECT_THAT("\n" + capture.out, Not(HasSubstr(line)));
    }
  }
  EXPECT_THAT(environment, Contains(::testing::StartsWith("PATH=")));
}

}  // namespace
}  // namespace rouleau::campaign
