// SPDX-License-Identifier: BSD-3-Clause
// Forces of whole membranes: gradients of the energy, invariances, and independence of the mask.
#include "membrane/membrane_forces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "membrane/transform.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::norm;
using test::numerical_force;
using test::one_cell;
using test::relative_difference;
using test::strongly_deformed;

constexpr Moduli skalak_only{.kappa_S = 1, .kappa_A = 100, .kappa_B = 0};
constexpr Moduli neo_hookean_only{.kappa_S = 1, .law = InPlaneLaw::neo_hookean};
constexpr Moduli bending_only{.kappa_S = 0, .kappa_A = 0, .kappa_B = 1};
constexpr Moduli both{.kappa_S = 1, .kappa_A = 100, .kappa_B = 1};

struct Deformation {
  const char* name;
  double roughness;  // of the radius
};

class MembraneGradient : public testing::TestWithParam<Deformation> {
 protected:
  Cells cells_ = one_cell(strongly_deformed(red_blood_cell(2, 4), GetParam().roughness), red_blood_cell(2, 4));
  MembraneForces forces_{cells_};
  // Edges are 1 long. Fourth order: the truncation is h^4 = 1e-12, round-off 1e-16 E / h / F, about 1e-11.
  static constexpr double h = 1e-3;
};

TEST_P(MembraneGradient, SkalakForceIsMinusTheGradientOfItsEnergy) {
  forces_.compute(cells_, skalak_only);
  const VectorArray force = cells_.F;
  const auto energy = [&] { return forces_.energy(cells_, skalak_only).in_plane; };
  EXPECT_LT(relative_difference(numerical_force(cells_, h, energy), force), 1e-9);
}

TEST_P(MembraneGradient, NeoHookeanForceIsMinusTheGradientOfItsEnergy) {
  forces_.compute(cells_, neo_hookean_only);
  const VectorArray force = cells_.F;
  const auto energy = [&] { return forces_.energy(cells_, neo_hookean_only).in_plane; };
  // Where triangles are squeezed, 1 / (lambda1 lambda2)^2 is steep: truncation asks for a smaller step.
  EXPECT_LT(relative_difference(numerical_force(cells_, GetParam().roughness > 0.02 ? h / 4 : h, energy), force), 1e-9);
}

TEST_P(MembraneGradient, BendingForceIsMinusTheGradientOfItsEnergy) {
  forces_.compute(cells_, bending_only);
  const VectorArray force = cells_.F;
  const auto energy = [&] { return forces_.energy(cells_, bending_only).bending; };
  EXPECT_LT(relative_difference(numerical_force(cells_, GetParam().roughness > 0.02 ? h / 10 : h, energy), force),
            1e-8);
}

INSTANTIATE_TEST_SUITE_P(MembraneForces, MembraneGradient,
                         testing::Values(Deformation{"smooth", 0}, Deformation{"rough", 0.02},
                                         Deformation{"crumpled", 0.06}),
                         [](const auto& deformation) { return deformation.param.name; });

TEST(MembraneForces, TotalIsTheSumOfBothLaws) {
  Cells cells = one_cell(strongly_deformed(red_blood_cell(3, 4), 0.01), red_blood_cell(3, 4));
  MembraneForces forces(cells);
  forces.compute(cells, skalak_only);
  VectorArray sum = cells.F;
  forces.compute(cells, bending_only);
  for (std::size_t v = 0; v < sum.size(); ++v) set(sum, v, at(sum, v) + at(cells.F, v));
  forces.compute(cells, both);
  EXPECT_LT(relative_difference(sum, cells.F), 1e-14);  // another order of summation
}

TEST(MembraneForces, TotalForceAndTorqueVanish) {
  for (const Moduli& moduli : {skalak_only, neo_hookean_only, bending_only}) {
    Cells cells = one_cell(strongly_deformed(red_blood_cell(3, 4), 0.02), red_blood_cell(3, 4));
    MembraneForces(cells).compute(cells, moduli);
    Vec3 torque = Vec3::Zero();
    double size = 0;
    for (std::size_t v = 0; v < cells.vertices(); ++v) {
      torque += at(cells.X, v).cross(at(cells.F, v));
      size += at(cells.F, v).norm();
    }
    EXPECT_LT(test::total(cells.F).norm() / size, 1e-14);  // round-off; 1e-12 is asked for
    EXPECT_LT(torque.norm() / (4 * size), 1e-14);
  }
}

TEST(MembraneForces, UndeformedMeshHasExactlyNoForceInThePlane) {
  for (const Moduli& moduli : {skalak_only, neo_hookean_only}) {
    for (const Surface& shape : {red_blood_cell(4, 12), strongly_deformed(sphere(3, 5), 0.02)}) {
      Cells cells = one_cell(shape);
      MembraneForces forces(cells);
      forces.compute(cells, moduli);
      EXPECT_EQ(norm(cells.F), 0);
      EXPECT_EQ(forces.energy(cells, moduli).in_plane, 0);
    }
  }
}

TEST(MembraneForces, BothLawsAgreeWhereStrainsAreSmall) {
  // Neo-Hookean is Skalak with C = 1 to first order in the strain: the forces differ by its square.
  constexpr Moduli skalak_1{.kappa_S = 1, .kappa_A = 1};
  Cells cells = one_cell(ellipsoid(3, Vec3(5.005, 4.998, 4.99)), sphere(3, 5));
  MembraneForces forces(cells);
  forces.compute(cells, skalak_1);
  const VectorArray skalak = cells.F;
  forces.compute(cells, neo_hookean_only);
  EXPECT_LT(relative_difference(cells.F, skalak), 1e-2);
  EXPECT_GT(relative_difference(cells.F, skalak), 1e-5);  // they are two laws
}

TEST(MembraneForces, RigidMotionGivesNoSkalakForceButRoundOff) {
  Surface moved = red_blood_cell(3, 12);
  rotate(moved, {1, -2, 0.5}, 1.1);
  translate(moved, {60, 18, 15});
  Cells cells = one_cell(moved, red_blood_cell(3, 12));
  MembraneForces(cells).compute(cells, skalak_only);
  // Coordinates near 60 carry 1e-14; times kappa_A = 100, over the edge of 1.5.
  for (std::size_t v = 0; v < cells.vertices(); ++v) EXPECT_LT(at(cells.F, v).norm(), 1e-11);
}

TEST(MembraneForces, TurnWithTheCell) {
  const Surface reference = red_blood_cell(3, 4);
  const Surface shape = strongly_deformed(reference, 0.02);
  Cells cells = one_cell(shape, reference);
  MembraneForces(cells).compute(cells, both);
  Surface turned = shape;
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  rotate(turned, axis, 2.1);
  translate(turned, {5, -3, 8});
  Cells turned_cells = one_cell(turned, reference);
  MembraneForces(turned_cells).compute(turned_cells, both);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2.1, axis).toRotationMatrix();
  VectorArray expected(cells.vertices());
  for (std::size_t v = 0; v < cells.vertices(); ++v) set(expected, v, rotation * at(cells.F, v));
  EXPECT_LT(relative_difference(turned_cells.F, expected), 1e-12);  // round-off
}

TEST(MembraneForces, BitsDoNotDependOnTheMask) {
  for (const Moduli& moduli : {both, skalak_only, neo_hookean_only}) {
    Cells cells = one_cell(strongly_deformed(red_blood_cell(4, 4), 0.005), red_blood_cell(4, 4));
    MembraneForces forces(cells);
    forces.compute(cells, moduli);
    const VectorArray all = cells.F;
    std::mt19937 random(3);
    for (int round = 0; round < 40; ++round) {
      // A fresh object has an empty workspace: nothing can be left over from the full computation.
      MembraneForces fresh(cells);
      std::vector<std::uint8_t> needed(cells.vertices(), 0);
      const std::size_t axis = random() % 3;
      const double cut = std::uniform_real_distribution<double>(-4, 4)(random);
      const bool single = round % 4 == 0;
      for (std::size_t v = 0; v < needed.size(); ++v) needed[v] = !single && at(cells.X, v)[axis] > cut;
      if (single) needed[random() % needed.size()] = 1;
      cells.F = VectorArray(cells.vertices());
      fresh.compute(cells, moduli, needed);
      for (std::size_t v = 0; v < needed.size(); ++v) {
        if (needed[v]) {
          ASSERT_EQ(at(cells.F, v), at(all, v)) << "vertex " << v << ", round " << round;
        }
      }
    }
  }
}

TEST(MembraneForces, EmptySelectionComputesNothing) {
  Cells cells = one_cell(sphere(2, 1.1), sphere(2, 1));
  const std::vector<std::uint8_t> needed(cells.vertices(), 0);
  MembraneForces(cells).compute(cells, both, needed);
  EXPECT_EQ(norm(cells.F), 0);
}

TEST(MembraneForces, CellsDoNotSeeEachOther) {
  const Surface first = strongly_deformed(sphere(2, 3), 0.01), second = strongly_deformed(red_blood_cell(3, 4), 0.01);
  const std::vector<CellStart> starts{{first, sphere(2, 3)}, {second, red_blood_cell(3, 4)}};
  Cells pair = assemble(starts);
  MembraneForces(pair).compute(pair, both);
  Cells alone = one_cell(second, red_blood_cell(3, 4));
  MembraneForces(alone).compute(alone, both);
  const auto begin = static_cast<std::size_t>(pair.ranges[1].vertex_begin);
  for (std::size_t v = 0; v < alone.vertices(); ++v) EXPECT_EQ(at(pair.F, begin + v), at(alone.F, v));
}

TEST(MembraneForces, ReferenceWithoutAreaIsRefused) {
  Surface flat = sphere(1, 1);
  for (double& x : flat.X.x) x = 0;
  for (double& y : flat.X.y) y = 0;
  const Cells cells = one_cell(sphere(1, 1), flat);
  EXPECT_THROW(MembraneForces{cells}, Error);
}

}  // namespace
}  // namespace rouleau
