// SPDX-License-Identifier: BSD-3-Clause
// A changed study meets a campaign.
#include "study/merge.hpp"

#include <gtest/gtest.h>

#include "small_checker.hpp"

namespace rouleau::campaign {
namespace {

Expansion expansion_of(const std::string& rest) {
  return expand(parse_study("[study]\nname = s\n[time]\nend_time_s = 1\n" + rest, "study.ini"), small_check);
}

/// The points as they lie in a campaign after `init` with this study.
std::vector<Point> campaign_of(const std::string& rest) {
  std::vector<Point> points;
  for (const Candidate& candidate : merge({}, expansion_of(rest)).added) points.push_back(candidate.point);
  return points;
}

TEST(CampaignMerge, FirstTimeEveryPointIsNewAndNumbered) {
  const std::vector<Point> points = campaign_of("[sweep]\nfluid.lambda = 1, 2, 3\n");
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0].ordinal, 1);
  EXPECT_EQ(points[2].ordinal, 3);
  EXPECT_EQ(points[0].key, points[0].identity.substr(0, 12));
}

TEST(CampaignMerge, SameStudyChangesNothing) {
  const char* study = "[sweep]\nfluid.lambda = 1, 2, 3\n";
  const Merge merged = merge(campaign_of(study), expansion_of(study));
  EXPECT_TRUE(merged.added.empty());
  EXPECT_TRUE(merged.dropped.empty());
  ASSERT_EQ(merged.kept.size(), 3U);
  for (const KeptPoint& kept : merged.kept) EXPECT_FALSE(Merge::has_grown(kept));
}

TEST(CampaignMerge, AddedValuesKeepOldPointsTheirKeysAndNumbers) {
  const std::vector<Point> before = campaign_of("[sweep]\nfluid.lambda = 1, 2\n");
  const Merge merged = merge(before, expansion_of("[sweep]\nfluid.lambda = 0.5, 1, 1.5, 2\n"));
  ASSERT_EQ(merged.kept.size(), 2U);
  EXPECT_EQ(merged.kept[0].now.point.key, before[0].key);
  EXPECT_EQ(merged.kept[1].now.point.ordinal, 2);
  ASSERT_EQ(merged.added.size(), 2U);
  EXPECT_EQ(merged.added[0].point.ordinal, 3);
  EXPECT_TRUE(merged.dropped.empty());
}

TEST(CampaignMerge, ChangedIdentityDropsAllAndAddsAll) {
  const std::vector<Point> before = campaign_of("[cell]\nradius_um = 4\n[sweep]\nfluid.lambda = 1, 2\n");
  const Merge merged = merge(before, expansion_of("[cell]\nradius_um = 3\n[sweep]\nfluid.lambda = 1, 2\n"));
  EXPECT_EQ(merged.added.size(), 2U);
  EXPECT_EQ(merged.dropped.size(), 2U);
  EXPECT_EQ(merged.added[0].point.ordinal, 3) << "numbers are never reused";
}

TEST(CampaignMerge, DroppedPointComesBackAsItWas) {
  std::vector<Point> before = campaign_of("[sweep]\nfluid.lambda = 1, 2\n");
  before[0].in_study = false;
  before[0].cancelled = true;
  const Merge merged = merge(before, expansion_of("[sweep]\nfluid.lambda = 1, 2\n"));
  ASSERT_EQ(merged.kept.size(), 2U);
  EXPECT_TRUE(merged.kept[0].now.point.in_study);
  EXPECT_TRUE(merged.kept[0].now.point.cancelled);
}

TEST(CampaignMerge, AlreadyDroppedPointIsNotDroppedAgain) {
  std::vector<Point> before = campaign_of("[sweep]\nfluid.lambda = 1, 2\n");
  before[0].in_study = false;
  EXPECT_TRUE(merge(before, expansion_of("[sweep]\nfluid.lambda = 2\n")).dropped.empty());
}

TEST(CampaignMerge, LaterEndIsTheSamePointGrown) {
  std::vector<Point> before = campaign_of("[sweep]\nfluid.lambda = 1\n");
  before[0].facts.steps = 500;
  const Merge merged = merge(before, expansion_of("[sweep]\nfluid.lambda = 1\n"));
  ASSERT_EQ(merged.kept.size(), 1U);
  EXPECT_TRUE(Merge::has_grown(merged.kept[0]));
}

}  // namespace
}  // namespace rouleau::campaign
