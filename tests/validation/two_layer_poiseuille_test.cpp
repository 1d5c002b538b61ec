// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow of two fluids, viscosity ratio 5, interface midway between nodes: the direct test of a local
// viscosity.
#include <gtest/gtest.h>

#include "analytic_flows.hpp"

namespace rouleau {
namespace {

constexpr double lambda = 5, nu_1 = 1.0 / 6, nu_2 = lambda * nu_1;

template <class Real>
double two_layer_error(const Collision& collision, int N) {
  return testing::two_layer_poiseuille_error<Real>(collision, {lambda, nu_1, N});
}

TEST(TwoLayerPoiseuille, OracleHasTheKnownValues) {
  EXPECT_NEAR(testing::two_layers(-1e-12, lambda), 1.0 / 6, 1e-11);
  EXPECT_NEAR(testing::two_layers(-1.0 / 3, lambda), 2.0 / 9, 1e-15);
  EXPECT_NEAR(testing::two_layers(1, lambda), 0, 1e-16);
  EXPECT_NEAR(testing::core_and_sheath(0, lambda), 0.4, 1e-15);
}

TEST(TwoLayerPoiseuille, TrtIsExact) {
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_1, nu_2), 10), 1e-9);
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_1, nu_2), 20), 1e-9);
}

TEST(TwoLayerPoiseuille, TrtIsExactForACoreInASheath) {
  const auto is_core = [](double y) { return std::abs(y) < 0.5; };
  EXPECT_LT(testing::two_fluid_poiseuille_error<double>(testing::two_trt(nu_1, nu_2), {lambda, nu_1, 20},
                                                        testing::core_and_sheath, is_core),
            1e-9);
}

TEST(TwoLayerPoiseuille, TrtIsExactToSinglePrecision) {
  // As in the plane channel; the unit is the velocity scale, of which the flow reaches a fifth.
  EXPECT_LT(two_layer_error<float>(testing::two_trt(nu_1, nu_2), 10), 1e-5);
}

TEST(TwoLayerPoiseuille, OtherMagicNumbersConvergeWithTheirKnownError) {
  // Independent figures (two-dimensional lattice, another program): 8.1e-3 and 2.0e-3; two digits are known.
  const double coarse = two_layer_error<double>(testing::two_trt(nu_1, nu_2, 0.25), 10);
  const double fine = two_layer_error<double>(testing::two_trt(nu_1, nu_2, 0.25), 20);
  EXPECT_NEAR(coarse, 8.1e-3, 0.1e-3);
  EXPECT_NEAR(fine, 2.0e-3, 0.1e-3);
}

TEST(TwoLayerPoiseuille, MrtWithUnitGhostRatesConvergesWithItsKnownError) {
  const Collision mrt = TwoFluids<MrtRates<>>{mrt_rates(nu_1, 1, 1), mrt_rates(nu_2, 1, 1)};
  // 2.8e-2 and 7.1e-3 from the same source.
  EXPECT_NEAR(two_layer_error<double>(mrt, 10), 2.8e-2, 0.1e-2);
  EXPECT_NEAR(two_layer_error<double>(mrt, 20), 7.1e-3, 0.1e-3);
}

}  // namespace
}  // namespace rouleau
