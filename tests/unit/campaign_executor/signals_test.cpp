// SPDX-License-Identifier: BSD-3-Clause
// Signals as events.
#include "executor/signals.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace rouleau::campaign {
namespace {

TEST(CampaignSignals, AreReturnedInsteadOfKilling) {
  SignalWatch watch;
  EXPECT_EQ(watch.wait(0), 0);
  ::kill(::getpid(), SIGTERM);
  EXPECT_EQ(watch.wait(1000), SIGTERM);
  ::kill(::getpid(), SIGINT);
  EXPECT_EQ(watch.wait(1000), SIGINT);
  EXPECT_EQ(watch.wait(0), 0);
}

TEST(CampaignSignals, MaskIsRestored) {
  { const SignalWatch watch; }
  sigset_t now;
  ::sigprocmask(SIG_BLOCK, nullptr, &now);
  EXPECT_EQ(sigismember(&now, SIGINT), 0);
}

TEST(CampaignSignals, OneThatWasNotHeededDoesNotKillAtTheEnd) {
  {
    const SignalWatch watch;
    ::kill(::getpid(), SIGTERM);
    ::kill(::getpid(), SIGINT);
  }
  // Had one been left over, it would have ended this test; nor does one wait for whoever blocks signals next.
  sigset_t waiting;
  ::sigpending(&waiting);
  EXPECT_EQ(sigismember(&waiting, SIGTERM), 0);
  EXPECT_EQ(sigismember(&waiting, SIGINT), 0);
}

TEST(CampaignSignals, HangUpStaysIgnoredUnderNohup) {
  const auto before = ::signal(SIGHUP, SIG_IGN);
  {
    SignalWatch watch;
    ::kill(::getpid(), SIGHUP);
    EXPECT_EQ(watch.wait(50), 0);
  }
  ::signal(SIGHUP, before);
}

}  // namespace
}  // namespace rouleau::campaign
