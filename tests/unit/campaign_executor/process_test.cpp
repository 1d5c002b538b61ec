// SPDX-License-Identifier: BSD-3-Clause
// Telling processes apart.
#include "executor/process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

pid_t sleeping_child() {
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::pause();
    ::_exit(0);
  }
  return pid;
}

TEST(CampaignProcess, WeLive) {
  const ProcessIdentity self = identity_of(::getpid()).value();
  EXPECT_EQ(self.host, host_name());
  EXPECT_EQ(self.boot_id, boot_id());
  EXPECT_GT(self.start_ticks, 0);
  EXPECT_EQ(life_of(self), Life::alive);
}

TEST(CampaignProcess, KilledOneIsDeadEvenAsAZombie) {
  const pid_t pid = sleeping_child();
  const ProcessIdentity child = identity_of(pid).value();
  EXPECT_EQ(life_of(child), Life::alive);
  ::kill(pid, SIGKILL);
  EXPECT_TRUE(rouleau::testing::eventually([&] { return life_of(child) == Life::dead; })) << "it is not waited for yet";
  ::waitpid(pid, nullptr, 0);
  EXPECT_EQ(life_of(child), Life::dead);
}

TEST(CampaignProcess, ReusedNumberIsAnotherProcess) {
  ProcessIdentity other = identity_of(::getpid()).value();
  other.start_ticks -= 1;
  EXPECT_EQ(life_of(other), Life::dead);
}

TEST(CampaignProcess, EarlierBootIsDead) {
  ProcessIdentity other = identity_of(::getpid()).value();
  other.boot_id = "00000000-0000-0000-0000-000000000000";
  EXPECT_EQ(life_of(other), Life::dead);
}

TEST(CampaignProcess, OtherHostIsUnknown) {
  ProcessIdentity other = identity_of(::getpid()).value();
  other.host = "elsewhere";
  EXPECT_EQ(life_of(other), Life::unknown);
}

TEST(CampaignProcess, NobodyIsNone) { EXPECT_EQ(life_of({}), Life::none); }

}  // namespace
}  // namespace rouleau::campaign
