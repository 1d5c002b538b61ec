// SPDX-License-Identifier: BSD-3-Clause
#include "speed/series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rouleau::speed {
namespace {

TEST(Spread, MedianAndQuartilesIgnoreTheOrder) {
  const Spread odd = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.lower_quartile, 2);
  EXPECT_EQ(odd.upper_quartile, 4);
  EXPECT_EQ(odd.min, 1);
  EXPECT_EQ(odd.max, 5);
  EXPECT_EQ(odd.count, 5U);
  EXPECT_EQ(spread_of({4, 1, 3, 2}).median, 2.5);
  EXPECT_EQ(spread_of({7}).upper_quartile, 7);
}

TEST(FittedExponent, FindsThePowerWhateverTheFactor) {
  std::vector<double> x{24, 36, 60, 96}, y;
  for (const double n : x) y.push_back(3e-7 * std::pow(n, 4.25));
  EXPECT_NEAR(fitted_exponent(x, y), 4.25, 1e-12);
}

TEST(Series, RatiosAreTakenRoundByRound) {
  Series series;
  // The second round ran at half speed, and something disturbed the third between its two measurements.
  for (const double v : {2.0, 4.0, 9.0}) series.add("numerator", v);
  for (const double v : {1.0, 2.0, 1.0}) series.add("denominator", v);
  series.derive_ratio("ratio", "numerator", "denominator");
  EXPECT_EQ(series.all().at("ratio"), (std::vector<double>{2, 2, 9}));
  EXPECT_EQ(series.median("ratio"), 2);
}

TEST(Series, WhatWasNotMeasuredGivesNoFigure) {
  Series series;
  series.add("numerator", 1);
  series.derive_ratio("ratio", "numerator", "denominator");
  EXPECT_FALSE(series.has("ratio"));
}

}  // namespace
}  // namespace rouleau::speed
