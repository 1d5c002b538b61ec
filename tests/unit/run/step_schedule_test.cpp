// SPDX-License-Identifier: BSD-3-Clause
// Steps at equal intervals of time.
#include "run/step_schedule.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rouleau {
namespace {

std::vector<std::int64_t> due(double interval, std::int64_t last) {
  std::vector<std::int64_t> steps;
  for (std::int64_t step = 0; step <= last; ++step)
    if (StepSchedule(interval).is_due(step)) steps.push_back(step);
  return steps;
}

TEST(StepSchedule, TakesTheStepsNearestToTheMultiples) {
  EXPECT_EQ(due(4.8, 30), (std::vector<std::int64_t>{0, 5, 10, 14, 19, 24, 29}));
  EXPECT_EQ(due(7, 21), (std::vector<std::int64_t>{0, 7, 14, 21}));
  EXPECT_EQ(due(1, 3), (std::vector<std::int64_t>{0, 1, 2, 3}));
  EXPECT_EQ(due(100, 99), (std::vector<std::int64_t>{0}));
}

TEST(StepSchedule, NeverWithoutAnInterval) {
  EXPECT_TRUE(due(0, 10).empty());
  EXPECT_EQ(StepSchedule(0).count(1000), 0);
}

TEST(StepSchedule, DoesNotDriftInAsManyStepsAsARunHas) {
  const StepSchedule schedule(6479.987);
  for (const std::int64_t n : {1, 1000, 9259}) {
    const auto step = static_cast<std::int64_t>(std::llround(6479.987 * static_cast<double>(n)));
    EXPECT_TRUE(schedule.is_due(step));
    EXPECT_FALSE(schedule.is_due(step - 1));
    EXPECT_FALSE(schedule.is_due(step + 1));
  }
}

TEST(StepSchedule, CountsWhatIsDue) {
  for (const double interval : {1.0, 1.3, 2.5, 4.8, 7.0, 33.33})
    for (std::int64_t last = 0; last < 120; ++last)
      EXPECT_EQ(StepSchedule(interval).count(last), static_cast<std::int64_t>(due(interval, last).size()))
          << interval << " " << last;
}

}  // namespace
}  // namespace rouleau
