// SPDX-License-Identifier: BSD-3-Clause
// The lock, between real processes.
#include "executor/lock.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "study/error.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::TemporaryDirectory;

/// A process that holds the lock until it is killed.
pid_t holder(const std::filesystem::path& directory) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    const CampaignLock lock(directory, "run");
    rouleau::testing::set_content(directory / "ready", "");
    for (;;) ::pause();
  }
  EXPECT_TRUE(rouleau::testing::eventually([&] { return std::filesystem::exists(directory / "ready"); }));
  return pid;
}

TEST(CampaignLockTest, SecondHolderIsRefusedAndToldWhoHasIt) {
  const TemporaryDirectory directory;
  const pid_t pid = holder(directory.path());
  try {
    const CampaignLock second(directory.path(), "sync");
    ADD_FAILURE() << "two hold it";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::locked);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("`rouleau run` (process " + std::to_string(pid)));
  }
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
}

TEST(CampaignLockTest, KilledHolderFreesIt) {
  const TemporaryDirectory directory;
  const pid_t pid = holder(directory.path());
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
  EXPECT_NO_THROW(CampaignLock(directory.path(), "run"));
}

TEST(CampaignLockTest, IsFreeAgainAtTheEndOfItsScope) {
  const TemporaryDirectory directory;
  { const CampaignLock first(directory.path(), "run"); }
  EXPECT_NO_THROW(CampaignLock(directory.path(), "run"));
}

TEST(CampaignLockTest, IsNotInheritedByPrograms) {
  const TemporaryDirectory directory;
  std::optional<CampaignLock> lock;
  lock.emplace(directory.path(), "run");
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::execlp("sleep", "sleep", "30", nullptr);
    ::_exit(1);
  }
  EXPECT_TRUE(rouleau::testing::eventually([&] {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/" + std::to_string(pid) + "/exe", error).filename() !=
           "campaign_executor_test";
  }));
  lock.reset();
  EXPECT_NO_THROW(CampaignLock(directory.path(), "run"));
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
}

}  // namespace
}  // namespace rouleau::campaign
