// SPDX-License-Identifier: BSD-3-Clause
// The bending law of one triangle, and the energy against published digits and a slow independent sum.
#include "membrane/bending.hpp"

#include <gtest/gtest.h>

#include <array>
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
  const Cotangents cot = cotangents(metric({2, 0, 0}, {0, 1, 0}));
  EXPECT_DOUBLE_EQ(cot.a, 0);
  EXPECT_DOUBLE_EQ(cot.b, 2);
  EXPECT_DOUBLE_EQ(cot.c, 0.5);
  EXPECT_DOUBLE_EQ(cot.inverse_D, 0.5);
}

TEST(MembraneBending, CornerAreasAddUpToTheTriangle) {
  const V3 u{1, 0.2, -0.3}, v{0.1, 0.9, 0.4};
  const CornerCurvatures c = corner_curvatures(u, v);
  const V3 N = cross(u, v);
  EXPECT_NEAR(c.A_a + c.A_b + c.A_c, 0.5 * std::sqrt(dot(N, N)), 1e-15);
}

/// Sum over the edges of cot_e q_e, from the angles by acos.
double shared_energy(const std::array<V3, 3>& X, const std::array<VertexCurvature, 3>& curvature) {
  double energy = 0;
  for (int o = 0; o < 3; ++o) {
    const int i = (o + 1) % 3, j = (o + 2) % 3;
    const Vec3 p = to_vec3(X[i] - X[o]), q = to_vec3(X[j] - X[o]), d = to_vec3(X[j] - X[i]);
    const double angle = std::acos(p.normalized().dot(q.normalized()));
    const Vec3 dP = to_vec3(curvature[j].P - curvature[i].P);
    energy += (dP.dot(d) - (curvature[i].S + curvature[j].S) * d.squaredNorm()) / std::tan(angle);
  }
  return energy;
}

TEST(MembraneBending, GradientOfOneTriangleIsThatOfItsShareOfTheEnergy) {
  const std::array<VertexCurvature, 3> curvature{
      {{{0.3, -0.2, 0.9}, 0.4}, {{-0.1, 0.5, 0.7}, 0.2}, {{0.2, 0.1, 1.1}, 0.7}}};
  const std::array<V3, 3> X{{{0.1, 0.2, 0.3}, {1.0, 0.1, -0.2}, {0.4, 0.9, 0.5}}};
  const V3 u = X[1] - X[0], v = X[2] - X[0];
  const BendingGradient gradient = bending_gradient(metric(u, v), u, v, curvature[0], curvature[1], curvature[2]);
  const CornerForces in_plane = metric_forces(gradient.by_metric, u, v);
  const std::array<V3, 3> by_corner{{{}, gradient.by_u - in_plane.b, gradient.by_v - in_plane.c}};
  const double h = 1e-5;
  for (const int corner : {1, 2}) {
    for (const V3 axis : {V3{1, 0, 0}, V3{0, 1, 0}, V3{0, 0, 1}}) {
      std::array<V3, 3> ahead = X, behind = X;
      ahead[corner] = ahead[corner] + h * axis;
      behind[corner] = behind[corner] - h * axis;
      const double slope = (shared_energy(ahead, curvature) - shared_energy(behind, curvature)) / (2 * h);
      EXPECT_NEAR(dot(by_corner[corner], axis), slope, 1e-9);  // second order: h^2 = 1e-10; round-off 1e-16 / h
    }
  }
}

TEST(MembraneBending, OneTriangleOfAFlatSheetHasNoForce) {
  const VertexCurvature flat{{0, 0, 0}, 0};
  const V3 u{1, 0, 0}, v{0.4, 0.8, 0};
  const BendingGradient gradient = bending_gradient(metric(u, v), u, v, flat, flat, flat);
  const CornerForces F = metric_forces(gradient.by_metric, u, v);
  for (const V3 part : {F.b, F.c, gradient.by_u, gradient.by_v}) EXPECT_EQ(dot(part, part), 0);
}

}  // namespace
}  // namespace rouleau
