// SPDX-License-Identifier: BSD-3-Clause
// Tension, area strain and curvature at the vertices.
#include "membrane/local_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"

namespace rouleau {
namespace {

constexpr double R = 8;
const Moduli skalak{0.02, 0.7, 0.001, InPlaneLaw::skalak};
const Moduli neo_hookean{0.02, 0, 0.001, InPlaneLaw::neo_hookean};

Cells cells_of(const Surface& surface) { return assemble(std::array{CellStart{surface, {}}}); }
Cells resting_sphere() { return cells_of(sphere(4, R)); }

Cells dilated(double factor) {
  Cells cells = resting_sphere();
  for (auto* x : {&cells.X.x, &cells.X.y, &cells.X.z})
    for (double& v : *x) v *= factor;
  return cells;
}

/// (T1 + T2) / 2 = W1 (I1 + 2) / J + 2 J W2 with J = lambda^2, for lambda1 = lambda2 = lambda.
double tension_of_dilation(double lambda, const Moduli& m) {
  const double J = lambda * lambda, I1 = 2 * J - 2, I2 = J * J - 1;
  const bool is_skalak = m.law == InPlaneLaw::skalak;
  const double W1 = is_skalak ? m.kappa_S / 6 * (I1 + 1) : m.kappa_S / 6;
  const double W2 = is_skalak ? -m.kappa_S / 6 + m.kappa_A / 6 * I2 : -m.kappa_S / 6 / ((1 + I2) * (1 + I2));
  return W1 * (I1 + 2) / J + 2 * J * W2;
}

TEST(LocalState, MembraneAtRestIsWithoutTensionAndStrain) {
  const LocalState state = local_state(resting_sphere(), skalak);
  for (std::size_t v = 0; v < state.tension.size(); ++v) {
    EXPECT_EQ(state.tension[v], 0);
    EXPECT_NEAR(state.area_strain[v], 0, 1e-15);
  }
}

TEST(LocalState, DilationGivesTheTensionOfTheLaw) {
  for (const Moduli& moduli : {skalak, neo_hookean})
    for (const double lambda : {0.9, 1.01, 1.2}) {
      const LocalState state = local_state(dilated(lambda), moduli);
      const double expected = tension_of_dilation(lambda, moduli);
      for (std::size_t v = 0; v < state.tension.size(); ++v) {
        EXPECT_NEAR(state.tension[v], expected, 1e-12 * moduli.kappa_S) << lambda;  // rounding
        EXPECT_NEAR(state.area_strain[v], lambda * lambda - 1, 1e-13) << lambda;
      }
    }
}

TEST(LocalState, PureShearLeavesTheAreaAndCostsLittleTension) {
  Cells cells = resting_sphere();
  // On the whole an ellipsoid; at the poles of y the surface is stretched by 1.1 along x and 1/1.1 along z.
  for (double& x : cells.X.x) x *= 1.1;
  for (double& z : cells.X.z) z /= 1.1;
  const LocalState state = local_state(cells, skalak);
  const auto pole = std::max_element(cells.X.y.begin(), cells.X.y.end()) - cells.X.y.begin();
  EXPECT_NEAR(state.area_strain[static_cast<std::size_t>(pole)], 0, 0.01);  // the mesh's triangles are not at the pole
  EXPECT_GT(*std::max_element(state.area_strain.begin(), state.area_strain.end()), 0.08);
}

TEST(LocalState, CurvatureOfASphereIsOneOverItsRadius) {
  for (const double factor : {1.0, 2.0}) {
    const LocalState state = local_state(dilated(factor), skalak);
    for (const double H : state.mean_curvature) EXPECT_NEAR(H * R * factor, 1, 0.01);  // 2562 vertices
  }
}

TEST(LocalState, CurvatureIsNegativeInADimple) {
  const Cells cells = cells_of(red_blood_cell(4, R));
  const LocalState state = local_state(cells, skalak);
  double in_dimple = 1, at_rim = -1;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const double r = std::hypot(cells.X.x[v], cells.X.y[v]);
    if (r < 0.1 * R) in_dimple = std::min(in_dimple, state.mean_curvature[v]);
    if (r > 0.98 * R) at_rim = std::max(at_rim, state.mean_curvature[v]);
  }
  EXPECT_LT(in_dimple, 0);
  EXPECT_GT(at_rim, 1 / R);
}

}  // namespace
}  // namespace rouleau
