// SPDX-License-Identifier: BSD-3-Clause
// Initial states, and the series of the developed channel flow.
#include "fluid/initial.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "fluid/developed.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(FluidDevelopedFlow, HasThePublishedValuesInATwelveByTenChannel) {
  const DevelopedFlow flow(12, 10);
  // Seven digits are known; the last of some is off by one (checked with the double sine series).
  EXPECT_NEAR(flow.maximum() / flow.mean(), 2.088638, 1e-6);
  EXPECT_NEAR(flow.mean() / 100, 0.04152973, 5e-9);
  EXPECT_NEAR(flow.velocity(1.5, 10.0 / 12) / flow.mean(), 1.936152, 5e-6);  // known at z = 0.8333
  EXPECT_NEAR(flow.velocity(3, 0) / flow.mean(), 1.653716, 1e-6);
  EXPECT_NEAR(flow.velocity(0, 2.5) / flow.mean(), 1.604860, 1.1e-6);
  EXPECT_NEAR(flow.velocity(5, 4) / flow.mean(), 0.326344, 5e-7);
}

TEST(FluidDevelopedFlow, HasThePublishedValuesAtOtherAspectRatios) {
  EXPECT_NEAR(DevelopedFlow(1, 1).maximum() / DevelopedFlow(1, 1).mean(), 2.096256, 5e-7);
  EXPECT_NEAR(DevelopedFlow(1, 1).mean(), 0.0351443, 5e-8);
  EXPECT_NEAR(DevelopedFlow(2, 1).maximum() / DevelopedFlow(2, 1).mean(), 1.991797, 1e-6);
  EXPECT_NEAR(DevelopedFlow(1, 4).mean(), 0.0702032, 5e-8);
}

TEST(FluidDevelopedFlow, DoesNotCareWhichSideIsLonger) {
  EXPECT_EQ(DevelopedFlow(36, 30).velocity(7, -11), DevelopedFlow(30, 36).velocity(-11, 7));
}

TEST(FluidDevelopedFlow, VanishesAtTheWallsAndSolvesPoissonsEquation) {
  const DevelopedFlow flow(36, 30);
  EXPECT_NEAR(flow.velocity(18, 3) / flow.maximum(), 0, 1e-9);  // the series converges like n^-2 there
  EXPECT_NEAR(flow.velocity(4, 15) / flow.maximum(), 0, 1e-14);
  const double h = 0.01, y = 9.3, z = -4.2;
  const double laplacian = (flow.velocity(y + h, z) + flow.velocity(y - h, z) + flow.velocity(y, z + h) +
                            flow.velocity(y, z - h) - 4 * flow.velocity(y, z)) /
                           (h * h);
  EXPECT_NEAR(laplacian, -1, 1e-7);  // values of 100 rounded at 1e-14, over h^2 = 1e-4
}

TEST(FluidDevelopedFlow, BetweenPlatesIsAParabola) {
  const DevelopedFlow flow(infinite, 20);
  EXPECT_DOUBLE_EQ(flow.maximum(), 50);
  EXPECT_DOUBLE_EQ(flow.mean(), 100.0 / 3);
  EXPECT_DOUBLE_EQ(flow.velocity(123, 5), 37.5);
}

TEST(FluidDevelopedFlow, NeedsAWall) {
  EXPECT_THROW(DevelopedFlow(infinite, infinite), Error);
  EXPECT_THROW(DevelopedFlow(0, 5), Error);
}

TEST(FluidInitial, DevelopedFlowHasTheMeanVelocityAsked) {
  Fluid<double> fluid({{8, 36, 30}, {true, false, false}}, {{0, 0, 0}, {8, 36, 30}});
  const Vec3 body_force(3e-6, 0, 0);
  set_developed(fluid, 7e-4, body_force);
  const auto momentum = testing::total_momentum(fluid);
  // Rounding of the fixed-point sum: below 1 unit a node.
  EXPECT_NEAR(mean_velocity(momentum[0], 8 * 36 * 30, body_force[0]), 7e-4, 1 / momentum_scale);
  EXPECT_EQ(momentum[1], 0);
  // At the node centres the mean of the exact field is 1.00111 times the true mean: the profile is scaled down by it.
  const DevelopedFlow flow(fluid.lattice);
  EXPECT_NEAR(fluid.u[0](3, 17, 14) / 7e-4, flow.velocity(0.5, 0.5) / flow.mean() / 1.00111, 2e-5);
}

TEST(FluidInitial, UniformFlowOfAPeriodicBoxLastsUnchanged) {
  Fluid<double> fluid({{7, 5, 6}, {true, true, true}}, {{0, 0, 0}, {7, 5, 6}});
  set_uniform(fluid, Vec3(0.01, -0.02, 0.03), Vec3::Zero());
  const auto momentum = testing::total_momentum(fluid);
  EXPECT_NEAR(double(momentum[2]) / momentum_scale / (7 * 5 * 6), 0.03, 1 / momentum_scale);
}

TEST(FluidInitial, ShearIsLinearBetweenTheWalls) {
  Fluid<double> fluid({{4, 4, 10}, {true, true, false}}, {{0, 0, 0}, {4, 4, 10}});
  fluid.wall_velocity[2] = {Vec3(-0.05, 0, 0), Vec3(0.05, 0, 0)};
  set_sheared(fluid, 2, Vec3::Zero());
  EXPECT_NEAR(fluid.u[0](1, 2, 0), -0.045, 1e-16);
  EXPECT_NEAR(fluid.u[0](1, 2, 9), 0.045, 1e-16);
  EXPECT_THROW(set_sheared(fluid, 0, Vec3::Zero()), Error);
}

}  // namespace
}  // namespace rouleau
