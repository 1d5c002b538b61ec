// SPDX-License-Identifier: BSD-3-Clause
// The energy of sharp edges: its value, its gradient, where it is nothing, and that no fold can close.
#include "membrane/fold_resistance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::norm;
using test::numerical_force;
using test::one_cell;
using test::relative_difference;
using test::strongly_deformed;
using test::total;

/// Half a cube's corners; outward normals at cos theta = -1/3 across each of the six edges.
Surface regular_tetrahedron() {
  Surface surface;
  surface.X.resize(4);
  set(surface.X, 0, {1, 1, 1});
  set(surface.X, 1, {1, -1, -1});
  set(surface.X, 2, {-1, 1, -1});
  set(surface.X, 3, {-1, -1, 1});
  surface.triangles.a = {0, 0, 0, 1};
  surface.triangles.b = {1, 2, 3, 3};
  surface.triangles.c = {2, 3, 1, 2};
  return surface;
}

/// A rough pancake: its rim folds back within one edge, its faces are resolved.
Surface pancake(double thickness) {
  Surface surface = sphere(2, 5);
  for (double& z : surface.X.z) z *= thickness;
  return strongly_deformed(surface, 0.01);
}

TEST(FoldResistance, HasTheEnergyOfARegularTetrahedron) {
  const Cells cells = one_cell(regular_tetrahedron());
  const double of_an_edge = std::pow(1.0 / 2 + 1.0 / 3, 2) / (1 - 1.0 / 3);
  EXPECT_NEAR(FoldResistance(cells, 3).energy(cells), 3 * 6 * of_an_edge, 1e-13);
}

TEST(FoldResistance, ForcesAreTheGradientOfTheEnergy) {
  for (const double thickness : {0.1, 0.06}) {
    Cells cells = one_cell(pancake(thickness));
    FoldResistance resistance(cells, 0.7);
    ASSERT_GT(resistance.energy(cells), 1);
    resistance.add(cells);
    const VectorArray F = cells.F;
    const VectorArray expected = numerical_force(cells, 1e-4, [&] { return resistance.energy(cells); });
    // The second derivative jumps where an edge turns sharp, which a difference can straddle: hence not 1e-10.
    EXPECT_LT(relative_difference(F, expected), 1e-7) << thickness;
  }
}

TEST(FoldResistance, PushesNoCellAndTurnsNone) {
  Cells cells = one_cell(pancake(0.1));
  FoldResistance(cells, 1).add(cells);
  Vec3 torque = Vec3::Zero();
  for (std::size_t v = 0; v < cells.vertices(); ++v) torque += at(cells.X, v).cross(at(cells.F, v));
  ASSERT_GT(norm(cells.F), 1);
  EXPECT_LT(total(cells.F).norm(), 1e-12 * norm(cells.F));
  EXPECT_LT(torque.norm(), 1e-11 * norm(cells.F));
}

TEST(FoldResistance, AddsExactlyNothingToAResolvedShape) {
  Cells cells = one_cell(strongly_deformed(red_blood_cell(4, 12), 0.002));
  cells.F.x.assign(cells.vertices(), 0.25);
  FoldResistance resistance(cells, 2);
  resistance.add(cells);
  EXPECT_EQ(resistance.energy(cells), 0);
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    ASSERT_EQ(cells.F.x[v], 0.25);
    ASSERT_EQ(cells.F.y[v], 0);
  }
}

TEST(FoldResistance, GrowsWithoutBoundAsAFoldCloses) {
  double last = 0;
  for (const double height : {0.1, 0.01, 0.001}) {
    Surface flat = regular_tetrahedron();
    for (double& z : flat.X.z) z *= height;
    const Cells cells = one_cell(flat);
    const double energy = FoldResistance(cells, 1).energy(cells);
    EXPECT_GT(energy, 50 * last);  // 1 + cos theta falls as the square of the height
    last = energy;
  }
}

}  // namespace
}  // namespace rouleau
