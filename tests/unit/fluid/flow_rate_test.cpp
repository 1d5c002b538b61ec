// SPDX-License-Identifier: BSD-3-Clause
// Order-free momentum and the check for bad nodes. (Independence of the cut is in decomposition_test.cpp.)
#include "fluid/flow_rate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

Fluid<double> swirling(double size) {
  Fluid<double> fluid({{21, 4, 3}, {true, true, true}}, {{100, 20, 30}, {21, 4, 3}});
  set_equilibrium(
      fluid, [size](const Int3& n) { return Vec3(size * testing::swirl(n)); }, Vec3::Zero());
  return fluid;
}

double& some_population(Fluid<double>& fluid, const Int3& node) { return fluid.f.at(3, node[0], node[1], node[2]); }

TEST(FluidMomentum, IsTheSumOfRoundedNodes) {
  const Fluid<double> fluid = swirling(0.01);
  std::array<std::int64_t, 3> slow{};
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 21; ++i)
        for (int a = 0; a < 3; ++a) slow[a] += std::llrint(fluid.u[a](i, j, k) * momentum_scale);
  const auto fast = testing::total_momentum(fluid);
  // u and sum c f differ in rounding of 1e-17, which moves a node by a unit of 1.5e-11 about once in 1e6.
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(double(fast[a]), double(slow[a]), 1) << a;
}

TEST(FluidMomentum, OfNegativeFlowIsMinusThatOfPositive) {
  const auto plus = testing::total_momentum(swirling(0.01)), minus = testing::total_momentum(swirling(-0.01));
  for (int a = 0; a < 3; ++a) EXPECT_EQ(plus[a], -minus[a]);  // odd parts are exact opposites
}

TEST(FluidMomentum, NamesTheNodeThatIsNotFinite) {
  Fluid<double> fluid = swirling(0.01);
  some_population(fluid, {5, 2, 1}) = std::nan("");
  try {
    (void)momentum_fixed_point(fluid, 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("(105, 22, 31)"));
  }
}

TEST(FluidMomentum, RefusesWhatItsSumCouldNotHold) {
  Fluid<double> fluid = swirling(0.01);
  some_population(fluid, {20, 3, 2}) += 0.2;
  EXPECT_THROW((void)momentum_fixed_point(fluid, 1), Error);
}

TEST(FluidSpeed, FindsTheLargest) {
  const SpeedCheck check = check_speed(swirling(0.01), 0.1);
  EXPECT_FALSE(check.first_bad.has_value());
  double largest = 0;
  for (int k = 30; k < 33; ++k)
    for (int j = 20; j < 24; ++j)
      for (int i = 100; i < 121; ++i) largest = std::max(largest, 0.01 * testing::swirl({i, j, k}).norm());
  EXPECT_NEAR(check.max_speed, largest, 1e-16);
}

TEST(FluidSpeed, FindsTheFirstBadNode) {
  Fluid<double> fluid = swirling(0.01);
  some_population(fluid, {3, 1, 2}) = std::nan("");
  some_population(fluid, {7, 0, 1}) = 0.5;  // comes before it
  const SpeedCheck check = check_speed(fluid, 0.1);
  ASSERT_TRUE(check.first_bad.has_value());
  EXPECT_EQ(*check.first_bad, (Int3{107, 20, 31}));
  EXPECT_LT(check.max_speed, 0.1);
}

TEST(FluidSpeed, SeesABadRestPopulation) {
  Fluid<double> fluid = swirling(0.01);
  fluid.f.at(0, 20, 3, 2) = std::numeric_limits<double>::infinity();
  // Momentum over an infinite density is 0, which would pass as a speed.
  EXPECT_TRUE(check_speed(fluid, 0.1).first_bad.has_value());
}

}  // namespace
}  // namespace rouleau
