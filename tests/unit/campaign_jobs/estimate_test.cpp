// SPDX-License-Identifier: BSD-3-Clause
// Cost arithmetic, against figures done by hand.
#include "jobs/estimate.hpp"

#include <gtest/gtest.h>

namespace rouleau::campaign {
namespace {

TEST(CampaignEstimate, CoreHoursFollowFromSpeed) {
  // 1e6 nodes at 10 MLUPS are 0.1 s a step; 36000 steps are an hour, on two ranks two core-hours.
  const double cost = core_seconds_per_cost(10, 2, 1000000, 50.0);
  PlannedPoint point;
  point.steps_left = 36000;
  point.relative_cost_per_step = 50.0;
  EXPECT_NEAR(core_hours(point, cost), 2.0, 1e-12);  // a few roundings
  point.relative_cost_per_step = 100.0;
  EXPECT_NEAR(core_hours(point, cost), 4.0, 1e-12);
}

TEST(CampaignEstimate, DiskCountsKeptCheckpointsAndTheOneBeingWritten) {
  PlannedPoint point;
  point.checkpoint_bytes = 1 << 20;
  point.checkpoints_kept = 3;
  EXPECT_EQ(disk_MiB(point), 4.0);
  point.snapshot_bytes = 2 << 20;
  EXPECT_EQ(disk_MiB(point), 6.0);
  point.samples = 1000;
  EXPECT_GT(disk_MiB(point), 6.0);
}

// A line every five seconds was in no estimate.
TEST(CampaignEstimate, DiskCountsTheProgressLinesOfWeeks) {
  PlannedPoint point;
  point.hours = 3 * 7 * 24;
  EXPECT_NEAR(disk_MiB(point), 34.6, 0.1);  // 362880 lines of 100 bytes
  point.progress_interval_s = 60;
  EXPECT_NEAR(disk_MiB(point), 34.6 / 12, 0.1);
}

TEST(CampaignEstimate, WallClockCountsJobsAtATime) {
  EXPECT_EQ(hours_in_all({1, 1, 1, 1}, 2), 2);
  EXPECT_EQ(hours_in_all({3, 1, 1, 1}, 2), 3);
  EXPECT_EQ(hours_in_all({1, 1, 3}, 2), 4) << "in order: the long one starts second";
  EXPECT_EQ(hours_in_all({}, 2), 0);
}

TEST(CampaignEstimate, JobsFitTheCoresUnlessTold) {
  EXPECT_EQ(jobs_at_a_time(0, 2, 8, false), 4);
  EXPECT_EQ(jobs_at_a_time(9, 2, 8, false), 4);
  EXPECT_EQ(jobs_at_a_time(9, 2, 8, true), 9);
  EXPECT_EQ(jobs_at_a_time(0, 16, 8, false), 1);
}

}  // namespace
}  // namespace rouleau::campaign
