// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow of two fluids, viscosity ratio 5, interface midway between nodes: the direct test of a local
// viscosity.
#include <gtest/gtest.h>

#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

constexpr double lambda = 5, nu_1 = 1.0 / 6, nu_2 = lambda * nu_1;
constexpr double u_unit = 1e-3;  ///< G h^2 / nu_1

/// -h < y < 0: viscosity nu_1; 0 < y < h: nu_2. y in units of h, velocity in units of G h^2 / nu_1.
double two_layers(double y) {
  const double nu_j = y < 0 ? 1 : lambda;
  return (2 * nu_j / (1 + lambda) + (1 - lambda) / (1 + lambda) * y - y * y) / (2 * nu_j);
}

/// Core |y| < h/2 of viscosity nu_2 in a sheath of nu_1.
double core_and_sheath(double y) {
  const double a = std::abs(y);
  return a > 0.5 ? (1 - a * a) / 2 : 0.375 + (0.25 - a * a) / (2 * lambda);
}

template <class Real>
double l2_error(const Collision& collision, int N, double (*exact)(double), bool (*is_thick)(double)) {
  const Lattice lattice{{3, 2, N}, {true, true, false}};
  testing::OneBlock<Real> block(lattice, collision);
  const double h = N / 2.0;
  block.body_force = Vec3(u_unit * nu_1 / (h * h), 0, 0);
  set_uniform(block.fluid, Vec3::Zero(), block.body_force);
  const auto y_of = [&](int k) { return (k + 0.5 - h) / h; };
  for (int k = 0; k < N; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) block.inside(i, j, k) = is_thick(y_of(k)) ? 1 : 0;
  block.run(40 * N * N);
  double difference = 0, square = 0;
  for (int k = 0; k < N; ++k) {
    const double e = exact(y_of(k));
    difference += std::pow(block.u(0, 1, 1, k) / u_unit - e, 2);
    square += e * e;
  }
  return std::sqrt(difference / square);
}

template <class Real>
double two_layer_error(const Collision& collision, int N) {
  return l2_error<Real>(collision, N, two_layers, [](double y) { return y > 0; });
}

TEST(TwoLayerPoiseuille, OracleHasTheKnownValues) {
  EXPECT_NEAR(two_layers(-1e-12), 1.0 / 6, 1e-11);
  EXPECT_NEAR(two_layers(-1.0 / 3), 2.0 / 9, 1e-15);
  EXPECT_NEAR(two_layers(1), 0, 1e-16);
  EXPECT_NEAR(core_and_sheath(0), 0.4, 1e-15);
}

TEST(TwoLayerPoiseuille, TrtIsExact) {
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_1, nu_2), 10), 1e-9);
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_1, nu_2), 20), 1e-9);
}

TEST(TwoLayerPoiseuille, TrtIsExactForACoreInASheath) {
  const auto is_core = [](double y) { return std::abs(y) < 0.5; };
  EXPECT_LT(l2_error<double>(testing::two_trt(nu_1, nu_2), 20, core_and_sheath, is_core), 1e-9);
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
