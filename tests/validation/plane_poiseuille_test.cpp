// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow between two plates: exact for the magic number 3/16, off by a known slip for every other.
#include <gtest/gtest.h>

#include "analytic_flows.hpp"

namespace rouleau {
namespace {

using testing::plane_channel_error;
using testing::ProfileError;

TEST(PlanePoiseuille, TrtIsExactAtEveryViscosity) {
  for (const double nu : {1.0 / 6, 5.0 / 6, 5.0 / 3})
    for (const int axis : {1, 2})
      EXPECT_LT(plane_channel_error<double>(testing::one_trt(nu), nu, axis, 10).largest, 1e-9)
          << nu << " axis " << axis;
}

TEST(PlanePoiseuille, TrtIsExactToSinglePrecision) {
  // Populations of 5e-4 rounded to 3e-11 act like random forces; between walls 10 nodes apart they add up to a few
  // 1e-9.
  EXPECT_LT(plane_channel_error<float>(testing::one_trt(1.0 / 6), 1.0 / 6, 2, 10).largest, 1e-5);
  EXPECT_LT(plane_channel_error<float>(testing::one_trt(5.0 / 6), 5.0 / 6, 2, 10).largest, 1e-5);
}

TEST(PlanePoiseuille, MrtWithTheRatesOfTrtIsExact) {
  const MrtRates<> rates = mrt_rates_of_trt(trt_rates(5.0 / 6));
  EXPECT_LT(plane_channel_error<double>(TwoFluids<MrtRates<>>{rates, rates}, 5.0 / 6, 2, 10).largest, 1e-9);
}

/// All nodes are off by the same slip.
void expect_slip(const ProfileError& error, double magic, int N) {
  const double slip = testing::plane_channel_slip(magic, N);
  EXPECT_NEAR(error.mean, slip, 1e-7);  // terms of order u^2 = 1e-6 enter as soon as walls are not exact
  EXPECT_NEAR(error.largest, std::abs(slip), 1e-7);
}

TEST(PlanePoiseuille, SlipOfTrtFollowsItsMagicNumber) {
  for (const double magic : {1.0 / 4, 1.0 / 12})
    for (const int N : {10, 16})
      expect_slip(plane_channel_error<double>(testing::one_trt(1.0 / 6, magic), 1.0 / 6, 2, N), magic, N);
}

TEST(PlanePoiseuille, SlipOfMrtWithUnitGhostRatesIsThatOfThreeHalvesTheViscosity) {
  for (const double nu : {1.0 / 6, 5.0 / 6}) {
    const MrtRates<> rates = mrt_rates(nu, 1, 1);
    expect_slip(plane_channel_error<double>(TwoFluids<MrtRates<>>{rates, rates}, nu, 2, 10), 1.5 * nu, 10);
  }
}

}  // namespace
}  // namespace rouleau
