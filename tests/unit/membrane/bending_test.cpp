// SPDX-License-Identifier: BSD-3-Clause
// The bending law of one triangle, and the energy against published digits and a slow independent sum.
#include "membrane/bending.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "membrane/membrane_forces.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;
using test::strongly_deformed;

double bending_of(const Surface& surface) {
  Cells cells = one_cell(surface);
  return MembraneForces(cells).energy(cells, {.kappa_S = 1, .kappa_A = 1, .kappa_B = 1}).bending;
}

/// Eqs. 10-13 as printed: a loop over neighbours, angles by acos.
double slow_bending_energy(const Surface& surface) {
  std::map<std::pair<int, int>, std::vector<int>> opposite;  // of each edge
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const int corner[3] = {surface.triangles.a[t], surface.triangles.b[t], surface.triangles.c[t]};
    for (int k = 0; k < 3; ++k) {
      const int i = corner[k], j = corner[(k + 1) % 3], o = corner[(k + 2) % 3];
      opposite[{i, j}].push_back(o);
      opposite[{j, i}].push_back(o);
    }
  }
  std::vector<Vec3> L(surface.X.size(), Vec3::Zero());
  std::vector<double> A(surface.X.size(), 0);
  for (const auto& [edge, corners] : opposite) {
    const auto [i, j] = edge;
    double weight = 0;
    for (const int o : corners) {
      const Vec3 p = at(surface.X, i) - at(surface.X, o), q = at(surface.X, j) - at(surface.X, o);
      weight += 1 / std::tan(std::acos(p.normalized().dot(q.normalized())));
    }
    const Vec3 d = at(surface.X, i) - at(surface.X, j);
    L[i] += weight * d;
    A[i] += weight * d.squaredNorm() / 8;
  }
  double energy = 0;
  for (std::size_t v = 0; v < A.size(); ++v) energy += 0.5 * (L[v] / (2 * A[v])).squaredNorm() * A[v];
  return energy;
}

TEST(MembraneBending, SphereHasTheEnergyOfEightPi) {
  // Digits computed independently; the discrete energy is below 8 pi by the ratio of the areas.
  EXPECT_NEAR(bending_of(sphere(3, 1)) / (8 * std::numbers::pi), 0.995259, 5e-7);
  EXPECT_NEAR(bending_of(sphere(4, 1)) / (8 * std::numbers::pi), 0.998809, 6e-7);
  EXPECT_NEAR(bending_of(sphere(5, 1)) / (8 * std::numbers::pi), 0.999701, 6e-7);
}

TEST(MembraneBending, EnergyDoesNotDependOnTheSize) {
  EXPECT_NEAR(bending_of(sphere(3, 12)), bending_of(sphere(3, 1)), 1e-11);
}

TEST(MembraneBending, RedBloodCellEnergiesAreThePublishedOnes) {
  EXPECT_NEAR(bending_of(red_blood_cell(3, 4)), 47.4518, 6e-5);
  EXPECT_NEAR(bending_of(red_blood_cell(4, 4)), 48.2121, 6e-5);
  EXPECT_NEAR(bending_of(red_blood_cell(5, 4)), 48.4107, 6e-5);
}

TEST(MembraneBending, EnergyEqualsTheSumOverNeighbours) {
  for (const double roughness : {0.0, 0.02}) {
    const Surface shape = strongly_deformed(red_blood_cell(3, 4), roughness);
    EXPECT_NEAR(bending_of(shape) / slow_bending_energy(shape), 1, 1e-11);  // acos and tan lose a few digits
  }
}

TEST(MembraneBending, CotangentsAreThoseOfTheAngles) {
  const Cotangents cot = cotangents({2, 0, 0}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(cot.a, 0);
  EXPECT_DOUBLE_EQ(cot.b, 2);
  EXPECT_DOUBLE_EQ(cot.c, 0.5);
  EXPECT_DOUBLE_EQ(cot.normal.z, 1);
}

TEST(MembraneBending, CornerAreasAddUpToTheTriangle) {
  const V3 u{1, 0.2, -0.3}, v{0.1, 0.9, 0.4};
  const CornerCurvatures c = corner_curvatures(u, v);
  const V3 N = cross(u, v);
  EXPECT_NEAR(c.A_a + c.A_b + c.A_c, 0.5 * std::sqrt(dot(N, N)), 1e-15);
}

TEST(MembraneBending, OneTriangleOfAFlatSheetHasNoForce) {
  const VertexCurvature flat{{0, 0, 0}, 0};
  const CornerForces F = bending_forces({1, 0, 0}, {0.4, 0.8, 0}, flat, flat, flat, 1);
  EXPECT_EQ(dot(F.b, F.b) + dot(F.c, F.c), 0);
}

}  // namespace
}  // namespace rouleau
