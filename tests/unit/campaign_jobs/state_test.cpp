// SPDX-License-Identifier: BSD-3-Clause
// The words for states.
#include "jobs/state.hpp"

#include <gtest/gtest.h>

namespace rouleau::campaign {
namespace {

TEST(CampaignState, EveryWordNamesOneState) {
  for (const std::string_view word : state_words) EXPECT_EQ(word_of(state_of(word).value()), word);
  EXPECT_FALSE(state_of("finished").has_value());
}

}  // namespace
}  // namespace rouleau::campaign
