// SPDX-License-Identifier: BSD-3-Clause
// Claims and stop files.
#include "executor/attempt.hpp"

#include <gtest/gtest.h>

#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::set_content;
using rouleau::testing::TemporaryDirectory;

TEST(CampaignAttempt, IsClaimedOnce) {
  const TemporaryDirectory run;
  claim_attempt(run.path(), 1, "abc");
  EXPECT_EQ(content_of(run.path() / "attempts/1/owner"), "abc\n");
  EXPECT_THROW(claim_attempt(run.path(), 1, "def"), Error);
  EXPECT_EQ(content_of(run.path() / "attempts/1/owner"), "abc\n");
  claim_attempt(run.path(), 2, "def");
}

TEST(CampaignAttempt, TokensDiffer) {
  EXPECT_EQ(new_token().size(), 32U);
  EXPECT_NE(new_token(), new_token());
}

TEST(CampaignAttempt, StopFileMayBeMadeAndRemovedAgainAndAgain) {
  const TemporaryDirectory run;
  remove_stop_file(run.path());
  make_stop_file(run.path());
  make_stop_file(run.path());
  EXPECT_TRUE(std::filesystem::exists(run.path() / "stop"));
  remove_stop_file(run.path());
  EXPECT_FALSE(std::filesystem::exists(run.path() / "stop"));
}

TEST(CampaignAttempt, LastWordsAreTheLastLineThatSaysSomething) {
  const TemporaryDirectory run;
  const auto file = run.path() / "stderr";
  EXPECT_EQ(last_line(file), "");
  set_content(file, "one\ntwo\n\n-----\n  \n");
  EXPECT_EQ(last_line(file), "two");
  set_content(file, std::string(10000, 'x') + "\nthe end");
  EXPECT_EQ(last_line(file), "the end");
}

}  // namespace
}  // namespace rouleau::campaign
