// SPDX-License-Identifier: BSD-3-Clause
// Which points are started.
#include "jobs/schedule.hpp"

#include <gmock/gmock.h>

namespace rouleau::campaign {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Startable point(int ordinal, State state) { return {"p" + std::to_string(ordinal), ordinal, state, true, false, 0}; }

TEST(CampaignSchedule, StartsInOrderUpToTheJobs) {
  const std::vector<Startable> points = {point(1, State::waiting), point(2, State::waiting), point(3, State::waiting)};
  EXPECT_THAT(choose_starts(points, {2, 8, 1, false}, 0), ElementsAre("p1", "p2"));
}

TEST(CampaignSchedule, NeverTakesMoreCoresThanAreFree) {
  const std::vector<Startable> points = {point(1, State::waiting), point(2, State::waiting), point(3, State::waiting)};
  EXPECT_THAT(choose_starts(points, {3, 5, 2, false}, 0), ElementsAre("p1", "p2"));
  EXPECT_THAT(choose_starts(points, {3, 1, 2, false}, 0), IsEmpty());
  EXPECT_THAT(choose_starts(points, {3, 1, 2, true}, 0), ElementsAre("p1", "p2", "p3")) << "unless told";
}

TEST(CampaignSchedule, LivingJobsTakePlaces) {
  std::vector<Startable> points = {point(1, State::running), point(2, State::waiting), point(3, State::waiting)};
  points[0].has_live_process = true;
  EXPECT_THAT(choose_starts(points, {2, 8, 1, false}, 0), ElementsAre("p2"));
}

TEST(CampaignSchedule, CancelledJobThatStillStopsTakesItsPlace) {
  std::vector<Startable> points = {point(1, State::cancelled), point(2, State::waiting)};
  points[0].has_live_process = true;
  EXPECT_THAT(choose_starts(points, {1, 8, 1, false}, 0), IsEmpty());
}

TEST(CampaignSchedule, InterruptedPointsComeFirst) {
  const std::vector<Startable> points = {point(1, State::waiting), point(2, State::stopped), point(3, State::crashed)};
  EXPECT_THAT(choose_starts(points, {3, 8, 1, false}, 0), ElementsAre("p2", "p3", "p1"));
}

TEST(CampaignSchedule, FinalRunningAndForeignPointsAreNotStarted) {
  std::vector<Startable> points;
  int ordinal = 0;
  for (const State state :
       {State::running, State::done, State::failed, State::refused, State::exhausted, State::cancelled}) {
    points.push_back(point(++ordinal, state));
  }
  points.push_back(point(++ordinal, State::waiting));
  points.back().in_study = false;
  EXPECT_THAT(choose_starts(points, {9, 9, 1, false}, 0), IsEmpty());
  EXPECT_FALSE(has_work(points));
}

TEST(CampaignSchedule, PauseIsKeptAndKnown) {
  std::vector<Startable> points = {point(1, State::crashed), point(2, State::crashed)};
  points[0].retry_at_unix_s = 200;
  points[1].retry_at_unix_s = 150;
  EXPECT_THAT(choose_starts(points, {9, 9, 1, false}, 100), IsEmpty());
  EXPECT_EQ(next_retry(points, 100), 150);
  EXPECT_TRUE(has_work(points));
  EXPECT_THAT(choose_starts(points, {9, 9, 1, false}, 150), ElementsAre("p2"));
  EXPECT_THAT(choose_starts(points, {9, 9, 1, false}, 200), ElementsAre("p1", "p2"));
  EXPECT_EQ(next_retry(points, 200), 0);
}

}  // namespace
}  // namespace rouleau::campaign
