// SPDX-License-Identifier: BSD-3-Clause
// Suggestions.
#include "study/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rouleau::campaign {
namespace {

const std::vector<std::string> names = {"status", "show", "query", "run"};

TEST(CampaignNearest, FindsTheMistypedName) {
  EXPECT_EQ(nearest("sttaus", names), "status");
  EXPECT_EQ(nearest("querry", names), "query");
  EXPECT_EQ(did_you_mean("rnu", names), " Did you mean `run`?");
}

TEST(CampaignNearest, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest("xylophone", names), "");
  EXPECT_EQ(did_you_mean("xylophone", names), "");
}

}  // namespace
}  // namespace rouleau::campaign
