// SPDX-License-Identifier: BSD-3-Clause
// Starting real processes.
#include "executor/local.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "executor/attempt.hpp"
#include "executor/lock.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

class LocalJob : public ::testing::Test {
 protected:
  LocalJob() {
    ::setenv("FAKE_STEP_US", "1000", 1);
    set_content(run_ / "run.ini",
                "[channel]\nlength_x_um = 20\n[numerics]\ntime_step_us = 100\n[time]\nend_time_s = 1\n");
    claim_attempt(run_, 1, "token");
    order_.solver = FAKE_SOLVER_PROGRAM;
    order_.run_directory = run_;
    order_.token = "token";
    order_.cores = {allowed_cores().back()};
    order_.checkpoint_step = 7;
  }
  ~LocalJob() override {
    if (process_.pid > 0 && life_of(process_) == Life::alive) ::kill(static_cast<pid_t>(process_.pid), SIGKILL);
    ::usleep(1000);
    executor_.reap();
  }
  bool ends() {
    return eventually([&] { return executor_.life(process_) == Life::dead; });
  }
  rouleau::testing::TemporaryDirectory place_;
  std::filesystem::path run_ = place_.path();
  LocalExecutor executor_;
  Order order_;
  ProcessIdentity process_;
};

TEST_F(LocalJob, SaysItselfWhoItIs) {
  process_ = executor_.launch(order_);
  std::vector<std::string> warnings;
  const auto file = read_process_file(run_ / "attempts/1/process.json", warnings);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ((ProcessIdentity{file->host, file->boot_id, file->pid, file->start_ticks}), process_);
  EXPECT_EQ(file->ranks, 1);
  EXPECT_EQ(file->checkpoint_step, 7);
  EXPECT_EQ(executor_.life(process_), Life::alive);
}

TEST_F(LocalJob, HasItsOwnSessionCoresAndFiles) {
  process_ = executor_.launch(order_);
  const auto pid = static_cast<pid_t>(process_.pid);
  EXPECT_EQ(::getsid(pid), pid) << "a terminal's Ctrl-C must not reach it";
  EXPECT_EQ(cores_of(pid), order_.cores);
  const std::string fds = "/proc/" + std::to_string(pid) + "/fd/";
  EXPECT_EQ(std::filesystem::read_symlink(fds + "0"), "/dev/null");
  EXPECT_EQ(std::filesystem::read_symlink(fds + "1"), run_ / "attempts/1/stdout");
  EXPECT_EQ(std::filesystem::read_symlink(fds + "2"), run_ / "attempts/1/stderr");
}

TEST_F(LocalJob, IsAsNiceAsAskedAndSoIsItsSession) {
  order_.niceness = 7;
  process_ = executor_.launch(order_);
  const auto pid = static_cast<id_t>(process_.pid);
  EXPECT_EQ(::getpriority(PRIO_PROCESS, pid), 7);
  const std::filesystem::path session = "/proc/" + std::to_string(pid) + "/autogroup";  // not every kernel has it
  if (std::filesystem::exists(session)) {
    EXPECT_THAT(content_of(session), HasSubstr("nice 7"));
  }
}

TEST_F(LocalJob, InheritsNoOpenFileOfTheManager) {
  const CampaignLock lock(run_, "run");  // a job that had it open would keep it when the manager is gone
  process_ = executor_.launch(order_);
  int open_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/" + std::to_string(process_.pid) + "/fd")) {
    std::error_code closed;  // by the job, meanwhile
    EXPECT_NE(std::filesystem::read_symlink(entry.path(), closed), run_ / ".lock");
    ++open_files;
  }
  EXPECT_GE(open_files, 3);
}

TEST_F(LocalJob, RunsToItsEnd) {
  ::setenv("FAKE_STEP_US", "1", 1);
  set_content(run_ / "run.ini",
              "[channel]\nlength_x_um = 20\n[numerics]\ntime_step_us = 100\n[time]\nend_time_s = 0.01\n");
  process_ = executor_.launch(order_);
  ASSERT_TRUE(ends());
  std::vector<std::string> warnings;
  EXPECT_EQ(read_exit_file(run_ / "attempts/1/exit.json", warnings)->code, 0);
}

/// Whether a process that blocks SIGUSR2 was sent one.
bool was_sent(pid_t pid) {
  const std::string status = content_of("/proc/" + std::to_string(pid) + "/status");
  const std::size_t at = status.find("ShdPnd:");
  return (std::stoull(status.substr(at + 7), nullptr, 16) >> (SIGUSR2 - 1) & 1U) != 0;
}

TEST_F(LocalJob, IsNotAskedToStopWhenItsNumberIsAnothersNow) {
  set_content(run_ / "attempts/1/started.json", "{}");
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGUSR2);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  const pid_t stranger = ::fork();
  if (stranger == 0) {
    for (;;) ::pause();
  }
  ::sigprocmask(SIG_UNBLOCK, &signals, nullptr);
  process_ = identity_of(stranger).value();
  ProcessIdentity recorded = process_;
  --recorded.start_ticks;
  executor_.ask_to_stop(recorded, run_, 1);
  recorded = process_;
  recorded.boot_id = "00000000-0000-0000-0000-000000000000";
  executor_.ask_to_stop(recorded, run_, 1);
  EXPECT_FALSE(was_sent(stranger));
  executor_.ask_to_stop(process_, run_, 1);
  EXPECT_TRUE(was_sent(stranger)) << "this test would not see a signal";
}

TEST_F(LocalJob, StopsBehindACheckpointWhenAsked) {
  process_ = executor_.launch(order_);
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(run_ / "attempts/1/started.json"); }));
  executor_.ask_to_stop(process_, run_, 1);
  ASSERT_TRUE(ends());
  std::vector<std::string> warnings;
  const auto exit = read_exit_file(run_ / "attempts/1/exit.json", warnings);
  ASSERT_TRUE(exit.has_value());
  EXPECT_EQ(exit->code, 75);
  EXPECT_EQ(checkpoint_steps(run_).back(), exit->step);
}

TEST_F(LocalJob, IsNotSignalledBeforeItCatchesSignals) {
  // Without started.json nobody knows whether the signal is caught. Asked of ourselves, with all signals held back.
  sigset_t all, before, waiting;
  sigfillset(&all);
  ::sigprocmask(SIG_BLOCK, &all, &before);
  executor_.ask_to_stop(identity_of(::getpid()).value(), run_, 1);
  ::sigpending(&waiting);
  for (const int signal : {SIGUSR2, SIGTERM, SIGINT}) EXPECT_EQ(sigismember(&waiting, signal), 0) << signal;
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
}

/// The children of this thread, zombies too.
std::string children() {
  std::ifstream file(fmt::format("/proc/self/task/{}/children", ::gettid()));
  std::string pids;
  std::getline(file, pids);
  return pids;
}

TEST_F(LocalJob, ProgramThatIsNotThereIsAnErrorAndLeavesNoProcess) {
  executor_.reap();  // of an earlier test, which would vanish meanwhile
  const std::string before = children();
  order_.solver = "/nowhere/rouleau-solver";
  try {
    process_ = executor_.launch(order_);
    FAIL() << "was started";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/rouleau-solver"));
    EXPECT_THAT(error.what(), HasSubstr("No such file"));
  }
  EXPECT_EQ(children(), before) << "a child is left";
}

TEST_F(LocalJob, WithoutAnAttemptDirectoryIsAnError) {
  order_.attempt = 2;
  EXPECT_THROW(process_ = executor_.launch(order_), Error);
}

TEST(LocalCommand, OneRankNeedsNoMpirun) {
  const Order order{"/x/rouleau-solver", "/r", 3, "t", 1, -1, {0}, 0};
  EXPECT_THAT(job_command(order),
              ::testing::ElementsAre("/x/rouleau-solver", "run.ini", "--attempt", "3", "--token", "t"));
}

TEST(LocalCommand, MoreRanksRunUnderMpirunUnbound) {
  const Order order{"/x/rouleau-solver", "/r", 3, "t", 2, -1, {0, 1}, 0};
  EXPECT_THAT(job_command(order),
              ::testing::ElementsAre("mpirun", "-n", "2", "--host", "localhost:2", "--bind-to", "none",
                                     "/x/rouleau-solver", "run.ini", "--attempt", "3", "--token", "t"));
}

TEST(LocalCommand, RanksWithoutCoresOfTheirOwnYield) {
  EXPECT_THAT(mpi_prefix(4, 2), ::testing::Contains("mpi_yield_when_idle"));
  EXPECT_THAT(mpi_prefix(4, 4), ::testing::Not(::testing::Contains("mpi_yield_when_idle")));
}

}  // namespace
}  // namespace rouleau::campaign
