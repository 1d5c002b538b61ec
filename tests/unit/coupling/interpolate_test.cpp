// SPDX-License-Identifier: BSD-3-Clause
// Interpolation is exact for what it must be exact for, is adjoint to spreading, and keeps the wall rule.
#include "coupling/interpolate.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "coupling/spread.hpp"
#include "points.hpp"
#include "support/blocks.hpp"

namespace rouleau {
namespace {

using testing::anywhere;
using testing::cut;
using testing::cuts;
using testing::fill;
using testing::for_each_node;
using testing::points;
using ::testing::Values;
using testing::whole;

const Lattice channel{{14, 9, 8}, {true, false, false}};
const Lattice closed_box{{8, 9, 10}, {false, false, false}};
const Lattice open_box{{12, 11, 10}, {true, true, true}};
const WallVelocities standing;

template <class Real, class Velocity>
VectorField<Real> velocity_field(const Lattice& lattice, const Block& block, Velocity velocity) {
  VectorField<Real> u;
  for (std::size_t c = 0; c < 3; ++c) {
    u[c] = Field<Real>(block.size, 2);
    // Beyond walls stands what must not be read.
    fill(u[c], lattice, block, std::numeric_limits<Real>::quiet_NaN(), [&](const Int3& node) {
      return static_cast<Real>(velocity(Vec3(node[0], node[1], node[2]))[static_cast<Eigen::Index>(c)]);
    });
  }
  return u;
}

/// Interpolates the owned vertices of a block into cells.U.
template <class Real, class Velocity>
void interpolate_on(const Lattice& lattice, const Block& block, Kernel kernel, const WallVelocities& walls,
                    Velocity velocity, Cells& cells) {
  Stencils s(kernel, lattice, block, cells.vertices());
  find_stencils(cells, s);
  interpolate(velocity_field<Real>(lattice, block, velocity), walls, s, cells.U);
}

Vec3 rough(const Vec3& x) {
  return {std::sin(1.3 * x[0] + 2.1 * x[1]), std::cos(0.7 * x[1] * x[2]), std::sin(3.1 * x[2] + x[0])};
}

class Interpolate : public ::testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(Kernels, Interpolate, Values(Kernel::two_point, Kernel::three_point, Kernel::four_point));

TEST_P(Interpolate, IsExactForALinearVelocity) {
  std::mt19937 random(21);
  std::vector<Vec3> positions;
  for (int v = 0; v < 300; ++v) positions.push_back(testing::random_vector(random, 2.0, 7.0));
  Cells cells = points(positions);
  const Eigen::Matrix3d gradient{{0.1, -0.2, 0.3}, {0.4, 0.25, -0.1}, {-0.3, 0.2, -0.35}};
  const auto linear = [&](const Vec3& x) -> Vec3 { return Vec3(1, 2, 3) + gradient * x; };
  interpolate_on<double>(open_box, whole(open_box), GetParam(), standing, linear, cells);
  for (std::size_t v = 0; v < cells.vertices(); ++v)
    EXPECT_LT((at(cells.U, v) - linear(at(cells.X, v))).norm(), 1e-14);  // sum 1 and first moment 0 to rounding
}

TEST_P(Interpolate, IsAdjointToSpreadingWithoutWalls) {
  Cells cells = points(anywhere(open_box, 500, 22));
  testing::random_forces(cells, 23);
  interpolate_on<double>(open_box, whole(open_box), GetParam(), standing, rough, cells);
  double power_of_vertices = 0, power_of_nodes = 0;
  for (std::size_t v = 0; v < cells.vertices(); ++v) power_of_vertices += at(cells.F, v).dot(at(cells.U, v));
  Stencils s(GetParam(), open_box, whole(open_box), cells.vertices());
  find_stencils(cells, s);
  VectorField<double> g;
  g.fill(Field<double>(open_box.size, 0));
  spread(cells.F, s, g);
  for_each_node(whole(open_box), 0, [&](int i, int j, int k) {
    power_of_nodes += Vec3(g[0](i, j, k), g[1](i, j, k), g[2](i, j, k)).dot(rough(Vec3(i, j, k)));
  });
  EXPECT_NEAR(power_of_nodes, power_of_vertices, 1e-12);  // 500 terms of order 1
}

TEST_P(Interpolate, AConstantVelocityIsExactIfTheWallsMoveAlong) {
  const Vec3 u(0.3, -0.2, 0.1);
  WallVelocities walls;
  for (auto& axis : walls.u) axis.fill(u);
  for (const Lattice& lattice : {channel, closed_box}) {
    Cells cells = points(anywhere(lattice, 1000, 24));
    interpolate_on<double>(
        lattice, whole(lattice), GetParam(), walls, [&](const Vec3&) { return u; }, cells);
    for (std::size_t v = 0; v < cells.vertices(); ++v) EXPECT_LT((at(cells.U, v) - u).norm(), 1e-15);
  }
}

TEST_P(Interpolate, TakesStandingWallsAsFluidAtRest) {
  // On the wall a symmetric kernel has half its weight beyond it, whatever the kernel.
  Cells cells = points({{5.3, -0.5, 4.2}, {5.3, 8.5, 4.2}});
  const Vec3 u(0.3, -0.2, 0.1);
  interpolate_on<double>(
      channel, whole(channel), GetParam(), standing, [&](const Vec3&) { return u; }, cells);
  EXPECT_LT((at(cells.U, 0) - 0.5 * u).norm(), 1e-15);
  EXPECT_LT((at(cells.U, 1) - 0.5 * u).norm(), 1e-15);
}

TEST_P(Interpolate, TakesTheWallOfTheLaterAxisInACorner) {
  WallVelocities walls;
  walls.u[1][0] = Vec3(1, 0, 0);
  walls.u[2][0] = Vec3(0, 0, 1);
  Cells cells = points({{5.3, -0.5, -0.5}});
  interpolate_on<double>(
      channel, whole(channel), GetParam(), walls, [](const Vec3&) { return Vec3(0, 1, 0); }, cells);
  EXPECT_LT((at(cells.U, 0) - Vec3(0.25, 0.25, 0.5)).norm(), 1e-15);
}

template <class Real>
void expect_same_bits_on_any_cut(const Lattice& lattice, Kernel kernel) {
  WallVelocities walls;
  walls.u[2] = {Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)};
  Cells one = points(anywhere(lattice, 2000, 25));
  Cells parts_together = one;
  interpolate_on<Real>(lattice, whole(lattice), kernel, walls, rough, one);
  for (const Int3& parts : cuts()) {
    parts_together.U = VectorArray(one.vertices());
    for (const Block& block : cut(lattice, parts))
      interpolate_on<Real>(lattice, block, kernel, walls, rough, parts_together);
    for (std::size_t v = 0; v < one.vertices(); ++v) ASSERT_EQ(at(one.U, v), at(parts_together.U, v)) << v;
  }
}

TEST_P(Interpolate, GivesTheSameBitsOnAnyCut) {
  for (const Lattice& lattice : {channel, closed_box, open_box}) {
    expect_same_bits_on_any_cut<double>(lattice, GetParam());
    expect_same_bits_on_any_cut<float>(lattice, GetParam());
  }
}

TEST_P(Interpolate, SinglePrecisionDiffersByItsRoundingOnly) {
  Cells exact = points(anywhere(open_box, 500, 26)), coarse = exact;
  interpolate_on<double>(open_box, whole(open_box), GetParam(), standing, rough, exact);
  interpolate_on<float>(open_box, whole(open_box), GetParam(), standing, rough, coarse);
  for (std::size_t v = 0; v < exact.vertices(); ++v)
    EXPECT_LT((at(exact.U, v) - at(coarse.U, v)).norm(), 1e-7);  // each u of order 1 rounded at 6e-8, averaged
}

}  // namespace
}  // namespace rouleau
