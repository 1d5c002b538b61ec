// SPDX-License-Identifier: BSD-3-Clause
// Vertices move with the right order in time, and never through a wall unnoticed.
#include "coupling/advect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "points.hpp"

namespace rouleau {
namespace {

using ::testing::HasSubstr;
using testing::points;

const Lattice channel{{14, 9, 8}, {true, false, false}};
const Lattice free_space{{100, 100, 100}, {true, true, true}};

TEST(Advect, EulerMovesByTheVelocity) {
  Cells cells = points({{1, 2, 3}, {4, 5, 6}});
  set(cells.U, 0, {0.25, -0.5, 0.125});
  advect(cells, Advection::euler, channel);
  EXPECT_EQ(at(cells.X, 0), Vec3(1.25, 1.5, 3.125));
  EXPECT_EQ(at(cells.X, 1), Vec3(4, 5, 6));
}

TEST(Advect, AdamsBashforthTakesThreeHalvesOfThisStepAndMinusHalfOfTheLast) {
  // More vertices than a vector register has lanes, and a rest.
  Cells cells = points(std::vector<Vec3>(19, Vec3(1, 2, 3)));
  for (std::size_t v = 0; v < 19; ++v) {
    set(cells.U, v, {0.25 * static_cast<double>(v), 0.5, 0});
    set(cells.U_previous, v, {0.5, 0, -0.125 * static_cast<double>(v)});
  }
  advect(cells, Advection::adams_bashforth, channel);
  for (std::size_t v = 0; v < 19; ++v) {
    EXPECT_EQ(at(cells.X, v), Vec3(0.75 + 0.375 * static_cast<double>(v), 2.75, 3 + 0.0625 * static_cast<double>(v)));
    EXPECT_EQ(at(cells.U_previous, v), at(cells.U, v));
  }
}

TEST(Advect, TheFirstAdamsBashforthStepIsAnEulerStep) {
  Cells cells = points({{1, 2, 3}});
  set(cells.U, 0, {0.25, -0.5, 0.125});  // exact in binary, and so is 3/2 U - 1/2 U
  start_history(cells);
  advect(cells, Advection::adams_bashforth, channel);
  EXPECT_EQ(at(cells.X, 0), Vec3(1.25, 1.5, 3.125));
}

/// Distance from the start after one turn on a circle of radius 10, in `steps` steps.
double error_after_a_turn(Advection scheme, int steps) {
  const Vec3 centre(50, 50, 50), start(60, 50, 50);
  const double rate = 2 * std::numbers::pi / steps;
  Cells cells = points({start});
  for (int step = 0; step < steps; ++step) {
    const Vec3 r = at(cells.X, 0) - centre;
    set(cells.U, 0, rate * Vec3(-r[1], r[0], 0));
    if (step == 0) start_history(cells);
    advect(cells, scheme, free_space);
  }
  return (at(cells.X, 0) - start).norm();
}

TEST(Advect, EulerIsOfFirstOrder) {
  EXPECT_NEAR(error_after_a_turn(Advection::euler, 800) / error_after_a_turn(Advection::euler, 1600), 2.0, 0.1);
}

TEST(Advect, AdamsBashforthIsOfSecondOrder) {
  EXPECT_NEAR(
      error_after_a_turn(Advection::adams_bashforth, 800) / error_after_a_turn(Advection::adams_bashforth, 1600), 4.0,
      0.1);
}

TEST(Advect, AveragedIsOfFirstOrder) {
  EXPECT_NEAR(error_after_a_turn(Advection::averaged, 800) / error_after_a_turn(Advection::averaged, 1600), 2.0, 0.1);
}

TEST(Advect, AveragedDoesNotSeeAVelocityThatAlternates) {
  Cells cells = points({{1, 2, 3}});
  for (int step = 0; step < 8; ++step) {
    set(cells.U, 0, step % 2 == 0 ? Vec3(0.25, -0.5, 0.125) : Vec3(-0.25, 0.5, -0.125));
    if (step == 0) set(cells.U_previous, 0, -at(cells.U, 0));
    advect(cells, Advection::averaged, channel);
    EXPECT_EQ(at(cells.X, 0), Vec3(1, 2, 3));
  }
}

TEST(Advect, NamesTheVertexThatGoesThroughAWall) {
  Cells cells = points({{1, 2, 3}, {4, 5, 0.25}});
  set(cells.U, 1, {0, 0, -1});
  try {
    advect(cells, Advection::euler, channel);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
    EXPECT_THAT(error.what(), HasSubstr("vertex 1 of cell 0 has gone through the low z wall"));
    EXPECT_THAT(error.what(), HasSubstr("(4, 5, -0.75)"));
  }
}

TEST(Advect, LetsAVertexThroughAPeriodicBorder) {
  Cells cells = points({{13.75, 5, 3}});
  set(cells.U, 0, {0.5, 0, 0});
  EXPECT_NO_THROW(advect(cells, Advection::euler, channel));
  EXPECT_EQ(at(cells.X, 0)[0], 14.25);
}

}  // namespace
}  // namespace rouleau
