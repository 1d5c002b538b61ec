// SPDX-License-Identifier: BSD-3-Clause
// The Skalak law at a point and on one triangle, against closed forms.
#include "membrane/skalak.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "membrane/moduli_conventions.hpp"

namespace rouleau {
namespace {

struct Invariants {
  double I1, I2;
};

Invariants invariants(double lambda1, double lambda2) {
  return {lambda1 * lambda1 + lambda2 * lambda2 - 2, lambda1 * lambda1 * lambda2 * lambda2 - 1};
}

// A reference triangle in the plane, and the same stretched along x and y, then turned out of the plane.
constexpr V3 u0{1.0, 0.1, 0}, v0{0.3, 0.8, 0};
V3 stretched(V3 a, double lambda1, double lambda2) {
  const V3 s{lambda1 * a.x, lambda2 * a.y, 0};
  return {0.6 * s.x - 0.8 * s.y, 0.48 * s.x + 0.36 * s.y, 0.64 * s.x + 0.48 * s.y};  // orthonormal columns
}

CornerForces skalak_forces(V3 u, V3 v, const ReferenceMetric& G, double kappa_S, double kappa_A) {
  return metric_forces(skalak_gradient(metric(u, v), G, kappa_S, kappa_A), u, v);
}

TEST(MembraneSkalak, PointValuesAgreeInAllThreeConventions) {
  const auto [I1, I2] = invariants(1.1, 0.95);
  EXPECT_NEAR(I1, 0.1125, 1e-15);
  EXPECT_NEAR(I2, 0.092025, 1e-15);
  for (const auto& [C, W] : {std::pair(100.0, 0.0750388594), std::pair(1.0, 0.0051729042)}) {
    const double half_digit = 5e-11;
    EXPECT_NEAR(skalak_energy_kappa_S(I1, I2, 1, C), W, half_digit);
    EXPECT_NEAR(skalak_energy_G_s(I1, I2, 1.0 / 3, C), W, half_digit);
    EXPECT_NEAR(skalak_energy_B(I1, I2, 2.0 / 3, 2.0 / 3 * C), W, half_digit);
    const ReferenceMetric G = reference_metric(metric(u0, v0));
    const double E = skalak_energy(metric(stretched(u0, 1.1, 0.95), stretched(v0, 1.1, 0.95)), G, 1, C);
    EXPECT_NEAR(E / G.area, W, half_digit);
  }
}

TEST(MembraneSkalak, ModuliConvertByThreeAndOneAndAHalf) {
  EXPECT_DOUBLE_EQ(to_kappa_S(ShearConvention::G_s, 2), 6);
  EXPECT_DOUBLE_EQ(to_kappa_S(ShearConvention::B, 2), 3);
  EXPECT_DOUBLE_EQ(to_kappa_S(ShearConvention::kappa_S, 2), 2);
  EXPECT_DOUBLE_EQ(from_kappa_S(ShearConvention::B, 3), 2);
  EXPECT_DOUBLE_EQ(from_kappa_S(ShearConvention::G_s, 3), 1);
}

TEST(MembraneSkalak, InvariantsAreThoseOfTheStretches) {
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  for (const auto& [l1, l2] : {std::pair(1.1, 0.95), std::pair(0.5, 2.0), std::pair(1 + 1e-9, 1.0)}) {
    const Strain e = strain(metric(stretched(u0, l1, l2), stretched(v0, l1, l2)), G);
    const auto [I1, I2] = invariants(l1, l2);
    EXPECT_NEAR(e.I1, I1, 2e-15);  // round-off of numbers near one
    EXPECT_NEAR(e.I2, I2, 2e-15);
  }
}

TEST(MembraneSkalak, SmallStrainModuliAreAThirdOfKappaSAndTheAreaModulus) {
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  const double kappa_S = 1, kappa_A = 10, e = 1e-4;
  const auto energy = [&](double l1, double l2) {
    return skalak_energy(metric(stretched(u0, l1, l2), stretched(v0, l1, l2)), G, kappa_S, kappa_A) / G.area;
  };
  // W = 2 G_s e^2 in pure shear, 2 K e^2 in dilation; the next order is e^3, and e / 1 = 1e-4.
  EXPECT_NEAR(energy(1 + e, 1 - e) / (2 * e * e), kappa_S / 3, 1e-3);
  EXPECT_NEAR(energy(1 + e, 1 + e) / (2 * e * e), (kappa_S + 2 * kappa_A) / 3, 1e-2);
}

TEST(MembraneSkalak, UniaxialTensionLeavesTheOtherDirectionFree) {
  // lambda2^2 = (1 + C l^2) / (1 + C l^4), and dW/dlambda1 = G_s l (I1 + 1 - lambda2^2 + C I2 lambda2^2).
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  for (const double C : {1.0, 10.0, 100.0}) {
    for (const double l : {0.8, 1.0, 1.3, 1.6}) {
      const double l2 = std::sqrt((1 + C * l * l) / (1 + C * std::pow(l, 4)));
      const V3 u{l * u0.x, l2 * u0.y, 0}, v{l * v0.x, l2 * v0.y, 0};
      const CornerForces F = skalak_forces(u, v, G, 3, 3 * C);  // G_s = 1
      const double along = -(F.b.x * u0.x + F.c.x * v0.x) / G.area, across = -(F.b.y * u0.y + F.c.y * v0.y) / G.area;
      const auto [I1, I2] = invariants(l, l2);
      EXPECT_NEAR(across, 0, 1e-12 * (1 + C));
      EXPECT_NEAR(along, l * (I1 + 1 - l2 * l2 + C * I2 * l2 * l2), 1e-12 * (1 + C));
    }
  }
}

TEST(MembraneSkalak, UniformDilationGivesIsotropicTension) {
  // An isotropic tension T pulls each corner with T/2 times the opposite edge, turned into the triangle by 90 degrees.
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  const double l = 1.2, C = 7;
  const V3 u = l * u0, v = l * v0;
  const CornerForces F = skalak_forces(u, v, G, 3, 3 * C);
  const auto [I1, I2] = invariants(l, l);
  const double tension = I1 + 1 - l * l + C * I2 * l * l;  // dW/dlambda1 / lambda2, G_s = 1
  const V3 normal{0, 0, 1};
  const V3 expected_b = (-tension / 2) * cross(v, normal), expected_c = (-tension / 2) * cross(normal, u);
  EXPECT_NEAR(F.b.x, expected_b.x, 1e-13);
  EXPECT_NEAR(F.b.y, expected_b.y, 1e-13);
  EXPECT_NEAR(F.c.x, expected_c.x, 1e-13);
  EXPECT_NEAR(F.c.y, expected_c.y, 1e-13);
}

TEST(MembraneSkalak, UndeformedTriangleHasExactlyNoForce) {
  const V3 u{0.1234, 0.777, -0.31}, v{-0.9, 0.3337, 0.21};
  const CornerForces F = skalak_forces(u, v, reference_metric(metric(u, v)), 0.3, 77.7);
  for (const V3 f : {F.b, F.c}) {
    EXPECT_EQ(f.x, 0);
    EXPECT_EQ(f.y, 0);
    EXPECT_EQ(f.z, 0);
  }
}

}  // namespace
}  // namespace rouleau
