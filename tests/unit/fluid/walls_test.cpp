// SPDX-License-Identifier: BSD-3-Clause
// Walls. (Walls in motion, in all combinations and corners, are compared in step_test.cpp.)
#include "fluid/walls.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

using testing::swirl;

TEST(FluidWalls, StandingOnesSendBackWhatArrives) {
  Fluid<double> fluid({{5, 4, 3}, {true, true, false}}, {{0, 0, 0}, {5, 4, 3}});
  set_equilibrium(
      fluid, [](const Int3& n) { return Vec3(0.02 * swirl(n)); }, Vec3::Zero());
  fill_halos(fluid);
  for (const int q : directions_out(2, 1)) {  // upward from below the lower wall
    const Int3 beyond{2 - c_q[q][0], 1 - c_q[q][1], -1};
    EXPECT_EQ(fluid.f.at(q, beyond[0], beyond[1], beyond[2]), fluid.f.at(opposite(q), 2, 1, 0));
  }
}

TEST(FluidWalls, RestStaysExactlyAtRest) {
  testing::OneBlock<float> block({{9, 5, 6}, {true, false, false}}, testing::two_trt(1.0 / 6, 5.0 / 6));
  set_uniform(block.fluid, Vec3::Zero(), Vec3::Zero());
  block.run(20);
  for (int q = 0; q < Q; ++q)
    for (int i = 0; i < 9; ++i) EXPECT_EQ(block.fluid.f.at(q, i, 0, 5), 0.0F);
}

TEST(FluidWalls, ClosedBoxBringsFluidToRest) {
  testing::OneBlock<double> block({{6, 6, 6}, {false, false, false}}, testing::one_trt(1.0 / 6));
  set_equilibrium(
      block.fluid, [](const Int3& n) { return Vec3(0.02 * swirl(n)); }, Vec3::Zero());
  block.run(2000);  // the slowest mode decays in 36 / (3 pi^2 / 6) = 7 steps
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(block.u(a, i, 2, 3), 0, 1e-16);
}

TEST(FluidWalls, OfABlockInsideTheLatticeAreNotFilled) {
  Fluid<double> middle({{4, 4, 12}, {true, true, false}}, {{0, 0, 4}, {4, 4, 4}});
  set_uniform(middle, Vec3(0.01, 0, 0), Vec3::Zero());
  const std::vector<double> before(middle.f.data.begin(), middle.f.data.end());
  fill_walls(middle);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), middle.f.data.begin()));
}

TEST(FluidWalls, ImpossibleVelocitiesAreRefused) {
  const Lattice channel{{8, 8, 8}, {true, false, false}};
  std::array<std::array<Vec3, 2>, 3> u;
  for (auto& sides : u) sides.fill(Vec3::Zero());
  EXPECT_NO_THROW(require_wall_velocities(channel, u));
  u[2][1] = Vec3(0.05, 0.02, 0);
  EXPECT_NO_THROW(require_wall_velocities(channel, u));
  u[2][1] = Vec3(0, 0, 0.01);  // into the fluid
  EXPECT_THROW(require_wall_velocities(channel, u), Error);
  u[2][1] = Vec3(0.5, 0, 0);  // beyond Mach 0.3
  EXPECT_THROW(require_wall_velocities(channel, u), Error);
  u[2][1] = Vec3(std::nan(""), 0, 0);
  EXPECT_THROW(require_wall_velocities(channel, u), Error);
  u[2][1] = Vec3::Zero();
  u[0][0] = Vec3(0, 0.01, 0);  // x has no walls
  EXPECT_THROW(require_wall_velocities(channel, u), Error);
}

}  // namespace
}  // namespace rouleau
