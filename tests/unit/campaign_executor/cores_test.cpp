// SPDX-License-Identifier: BSD-3-Clause
// Counting cores.
#include "executor/cores.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

namespace rouleau::campaign {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CampaignCores, OfThisProcessAreSome) {
  EXPECT_FALSE(allowed_cores().empty());
  EXPECT_EQ(cores_of(::getpid()), allowed_cores());
  EXPECT_THAT(cores_of(-1), IsEmpty());
}

TEST(CampaignCores, PinnedJobsTakeTheirs) {
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{1}, 1}, {{3}, 1}}), ElementsAre(0, 2));
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{0, 1, 2, 3}, 4}}), IsEmpty());
}

TEST(CampaignCores, UnpinnedJobsTakeAsManyAsTheyHaveRanks) {
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{0, 1, 2, 3}, 1}}), ElementsAre(0, 1, 2));
  EXPECT_THAT(free_cores({0, 1}, {{{0, 1, 2, 3}, 3}}), IsEmpty());
}

TEST(CampaignCores, JobsElsewhereDoNotMatter) { EXPECT_THAT(free_cores({0, 1}, {{{7}, 1}}), ElementsAre(0, 1)); }

TEST(CampaignCores, DeadOccupantTakesNothing) { EXPECT_THAT(free_cores({0, 1}, {{{}, 1}}), ElementsAre(0, 1)); }

TEST(CampaignCores, AreWrittenWithCommas) {
  EXPECT_EQ(to_text({0, 1, 5}), "0,1,5");
  EXPECT_EQ(to_text({}), "");
}

}  // namespace
}  // namespace rouleau::campaign
