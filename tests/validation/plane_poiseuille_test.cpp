// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow between two plates: exact for the magic number 3/16, off by a known slip for every other.
#include <gtest/gtest.h>

#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

constexpr double u_max = 1e-3;

/// Largest error and mean error over a channel of N nodes between walls of `axis`, both in units of u_max.
struct ProfileError {
  double largest = 0, mean = 0;
};

template <class Real>
ProfileError profile_error(const Collision& collision, double nu, int axis, int N) {
  Lattice lattice{{3, 2, 2}, {true, true, true}};
  lattice.size[axis] = N;
  lattice.periodic[axis] = false;
  testing::OneBlock<Real> block(lattice, collision);
  const double G = 8 * nu * u_max / (N * N);
  block.body_force = Vec3(G, 0, 0);
  set_uniform(block.fluid, Vec3::Zero(), block.body_force);
  block.run(static_cast<int>(40 * N * N / (9.87 * nu)) + 1000);  // 40 times the slowest decay: below 1e-16
  ProfileError error;
  for (int n = 0; n < N; ++n) {
    const double y = (n + 0.5) / N;
    Int3 node{1, 1, 1};
    node[axis] = n;
    const double e = block.u(0, node[0], node[1], node[2]) / u_max - 4 * y * (1 - y);
    error.largest = std::max(error.largest, std::abs(e));
    error.mean += e / N;
  }
  return error;
}

TEST(PlanePoiseuille, TrtIsExactAtEveryViscosity) {
  for (const double nu : {1.0 / 6, 5.0 / 6, 5.0 / 3})
    for (const int axis : {1, 2})
      EXPECT_LT(profile_error<double>(testing::one_trt(nu), nu, axis, 10).largest, 1e-9) << nu << " axis " << axis;
}

TEST(PlanePoiseuille, TrtIsExactToSinglePrecision) {
  // Populations of 5e-4 rounded to 3e-11 act like random forces; between walls 10 nodes apart they add up to a few
  // 1e-9.
  EXPECT_LT(profile_error<float>(testing::one_trt(1.0 / 6), 1.0 / 6, 2, 10).largest, 1e-5);
  EXPECT_LT(profile_error<float>(testing::one_trt(5.0 / 6), 5.0 / 6, 2, 10).largest, 1e-5);
}

TEST(PlanePoiseuille, MrtWithTheRatesOfTrtIsExact) {
  const MrtRates<> rates = mrt_rates_of_trt(trt_rates(5.0 / 6));
  EXPECT_LT(profile_error<double>(TwoFluids<MrtRates<>>{rates, rates}, 5.0 / 6, 2, 10).largest, 1e-9);
}

/// All nodes are off by the same slip, (16 magic - 3) / (3 N^2) of u_max.
void expect_slip(const ProfileError& error, double magic, int N) {
  const double slip = (16 * magic - 3) / (3.0 * N * N);
  EXPECT_NEAR(error.mean, slip, 1e-7);  // terms of order u^2 = 1e-6 enter as soon as walls are not exact
  EXPECT_NEAR(error.largest, std::abs(slip), 1e-7);
}

TEST(PlanePoiseuille, SlipOfTrtFollowsItsMagicNumber) {
  for (const double magic : {1.0 / 4, 1.0 / 12})
    for (const int N : {10, 16})
      expect_slip(profile_error<double>(testing::one_trt(1.0 / 6, magic), 1.0 / 6, 2, N), magic, N);
}

TEST(PlanePoiseuille, SlipOfMrtWithUnitGhostRatesIsThatOfThreeHalvesTheViscosity) {
  for (const double nu : {1.0 / 6, 5.0 / 6}) {
    const MrtRates<> rates = mrt_rates(nu, 1, 1);
    expect_slip(profile_error<double>(TwoFluids<MrtRates<>>{rates, rates}, nu, 2, 10), 1.5 * nu, 10);
  }
}

}  // namespace
}  // namespace rouleau
