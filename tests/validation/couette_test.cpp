// SPDX-License-Identifier: BSD-3-Clause
// Flow between sliding walls, of one fluid and of two.
#include <gtest/gtest.h>

#include "analytic_flows.hpp"

namespace rouleau {
namespace {

constexpr double U = 1e-3;
constexpr double lambda = 5, nu_out = 1.0 / 6;

TEST(Couette, IsExactBetweenWallsThatSlideOppositely) {
  for (const int axis : {1, 2}) {
    Lattice lattice{{3, 3, 3}, {true, true, true}};
    lattice.size[axis] = 12;
    lattice.periodic[axis] = false;
    testing::OneBlock<double> block(lattice, testing::one_trt(nu_out));
    const Vec3 along(U, axis == 2 ? 0.5 * U : 0, axis == 1 ? 0.5 * U : 0);
    block.fluid.wall_velocity[axis] = {Vec3(-along), along};
    block.run(4000);
    for (int n = 0; n < 12; ++n)
      for (int a = 0; a < 3; ++a) {
        Int3 node{1, 1, 1};
        node[axis] = n;
        EXPECT_NEAR(block.u(a, node[0], node[1], node[2]) / U, along[a] / U * (2 * (n + 0.5) / 12 - 1), 1e-11);
      }
  }
}

template <class Real>
double two_layer_error(const Collision& collision, int N) {
  return testing::two_layer_couette_error<Real>(collision, {lambda, nu_out, N});
}

TEST(Couette, InterfaceOfTwoViscositiesIsExact) {
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_out, lambda * nu_out), 10), 1e-10);
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_out, lambda * nu_out), 20), 1e-10);
  // Linear profiles are exact for every magic number, but for terms of order U^2 that only few rates cancel.
  EXPECT_LT(two_layer_error<double>(testing::two_trt(nu_out, lambda * nu_out, 0.25), 10), 1e-8);
  EXPECT_LT(
      two_layer_error<double>(TwoFluids<MrtRates<>>{mrt_rates(nu_out, 1, 1), mrt_rates(lambda * nu_out, 1, 1)}, 10),
      1e-8);
}

TEST(Couette, InterfaceOfTwoViscositiesIsExactToSinglePrecision) {
  // Populations of 3e-4 rounded to 1.5e-11, in units of U = 1e-3, added up over 10 nodes and many steps.
  EXPECT_LT(two_layer_error<float>(testing::two_trt(nu_out, lambda * nu_out), 10), 1e-5);
}

}  // namespace
}  // namespace rouleau
