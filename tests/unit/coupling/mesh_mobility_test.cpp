// SPDX-License-Identifier: BSD-3-Clause
// The local mobility of the mesh: its size for the shortest wave, its order for long ones, what it must not do.
#include "coupling/mesh_mobility.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <random>

#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"

namespace rouleau {
namespace {

Cells two_spheres() {
  std::vector<CellStart> starts;
  for (const double radius : {4.0, 6.0}) starts.push_back({sphere(Division::of_frequency(8), radius), std::nullopt});
  return assemble(starts);
}

std::vector<std::int32_t> all_vertices(const Cells& cells) {
  std::vector<std::int32_t> all(cells.vertices());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void clear(VectorArray& values) {
  for (Array<double>* component : {&values.x, &values.y, &values.z}) std::fill(component->begin(), component->end(), 0);
}

class MeshMobilityTest : public ::testing::Test {
 protected:
  MeshMobilityTest() {
    std::mt19937 random(7);
    std::uniform_real_distribution<> number(-1, 1);
    for (Array<double>* component : {&cells_.F.x, &cells_.F.y, &cells_.F.z})
      for (double& f : *component) f = number(random);
    clear(cells_.U);
  }

  Cells cells_ = two_spheres();
  std::vector<std::int32_t> all_ = all_vertices(cells_);
};

TEST_F(MeshMobilityTest, IsTheGraphLaplacianOfTheForces) {
  // Slow oracle: every pair of vertices that shares a triangle, once, by its edge.
  const double mobility = 0.2, viscosity_sum = 1.25;
  MeshMobility(cells_, mobility, viscosity_sum).add(cells_, all_);
  std::vector<Vec3> expected(cells_.vertices(), Vec3::Zero());
  std::vector<double> edges(2, 0), count(2, 0);
  const auto visit = [&](std::int32_t p, std::int32_t q) {
    if (p > q) return;  // the other triangle has it the other way round
    const auto v = static_cast<std::size_t>(p), w = static_cast<std::size_t>(q);
    const std::size_t cell = p < cells_.ranges[0].vertex_end ? 0 : 1;
    edges[cell] += (at(cells_.X_reference, v) - at(cells_.X_reference, w)).norm();
    count[cell] += 1;
    expected[v] += at(cells_.F, v) - at(cells_.F, w);
    expected[w] += at(cells_.F, w) - at(cells_.F, v);
  };
  for (std::size_t t = 0; t < cells_.triangles.size(); ++t) {
    visit(cells_.triangles.a[t], cells_.triangles.b[t]);
    visit(cells_.triangles.b[t], cells_.triangles.c[t]);
    visit(cells_.triangles.c[t], cells_.triangles.a[t]);
  }
  for (std::size_t v = 0; v < cells_.vertices(); ++v) {
    const std::size_t cell = static_cast<std::int32_t>(v) < cells_.ranges[0].vertex_end ? 0 : 1;
    const double m = mobility / (16 * std::numbers::pi * viscosity_sum * edges[cell] / count[cell]);
    EXPECT_LT((at(cells_.U, v) - m * expected[v]).norm(), 1e-14) << v;
  }
}

TEST_F(MeshMobilityTest, MovesNoCellAsAWholeAndOnlyTakesEnergy) {
  MeshMobility(cells_, 0.1, 1).add(cells_, all_);
  for (const CellRange& cell : cells_.ranges) {
    Vec3 sum = Vec3::Zero();
    double power = 0;
    for (auto v = static_cast<std::size_t>(cell.vertex_begin); v < static_cast<std::size_t>(cell.vertex_end); ++v) {
      sum += at(cells_.U, v);
      power += at(cells_.F, v).dot(at(cells_.U, v));
    }
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_GT(power, 0.1) << "the forces are minus the gradient of the energy: U along F lowers it";
  }
}

TEST_F(MeshMobilityTest, UniformForceMovesNothing) {
  for (Array<double>* component : {&cells_.F.x, &cells_.F.y, &cells_.F.z})
    std::fill(component->begin(), component->end(), 0.7);
  MeshMobility(cells_, 0.1, 1).add(cells_, all_);
  for (std::size_t v = 0; v < cells_.vertices(); ++v) EXPECT_EQ(at(cells_.U, v), Vec3::Zero()) << v;
}

TEST_F(MeshMobilityTest, ZeroChangesNoBit) {
  cells_.U.x[3] = 0.123;
  const Array<double> before = cells_.U.x;
  MeshMobility(cells_, 0, 1).add(cells_, all_);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), cells_.U.x.begin()));
}

TEST_F(MeshMobilityTest, NeedsTheNeighboursOfTheVerticesOwned) {
  const Lattice lattice{{32, 32, 32}, {true, true, true}};
  const Block half{{0, 0, 0}, {16, 32, 32}};
  for (std::size_t v = 0; v < cells_.vertices(); ++v) set(cells_.X, v, at(cells_.X, v) + Vec3::Constant(15.7));
  Stencils stencils(Kernel::two_point, lattice, half, cells_.vertices());
  find_stencils(cells_, stencils);
  MeshMobility mobility(cells_, 0.1, 1);
  const auto needed = mobility.needs(stencils);
  int beyond = 0;
  for (std::size_t t = 0; t < cells_.triangles.size(); ++t) {
    const std::array<std::int32_t, 3> corners{cells_.triangles.a[t], cells_.triangles.b[t], cells_.triangles.c[t]};
    for (const std::int32_t v : corners)
      if (stencils.owned_here[static_cast<std::size_t>(v)] != 0)
        for (const std::int32_t w : corners) {
          EXPECT_EQ(needed[static_cast<std::size_t>(w)], 1) << w;
          beyond += stencils.spreads_here[static_cast<std::size_t>(w)] == 0 ? 1 : 0;
        }
  }
  EXPECT_GT(beyond, 0) << "the block has no neighbour beyond its stencils: the test proves nothing";
}

}  // namespace
}  // namespace rouleau
