// SPDX-License-Identifier: BSD-3-Clause
// The neo-Hookean law at a point and on one triangle, against closed forms.
#include "membrane/neo_hookean.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rouleau {
namespace {

constexpr V3 u0{1.0, 0.1, 0}, v0{0.3, 0.8, 0};
constexpr double kappa_S = 3;  // G_s = 1

V3 stretched(V3 a, double lambda1, double lambda2) { return {lambda1 * a.x, lambda2 * a.y, 0}; }

/// dE/dlambda1 and dE/dlambda2 per reference area, from the forces: E changes by -F . dx.
struct Slopes {
  double along, across;
};

Slopes slopes(double lambda1, double lambda2) {
  const V3 u = stretched(u0, lambda1, lambda2), v = stretched(v0, lambda1, lambda2);
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  const CornerForces F = metric_forces(neo_hookean_gradient(metric(u, v), G, kappa_S), u, v);
  return {-(F.b.x * u0.x + F.c.x * v0.x) / G.area, -(F.b.y * u0.y + F.c.y * v0.y) / G.area};
}

double energy(double lambda1, double lambda2) {
  const ReferenceMetric G = reference_metric(metric(u0, v0));
  const Metric g = metric(stretched(u0, lambda1, lambda2), stretched(v0, lambda1, lambda2));
  return neo_hookean_energy(g, G, kappa_S) / G.area;
}

TEST(MembraneNeoHookean, PointValuesAreThoseOfTheStretches) {
  for (const auto& [l1, l2] : {std::pair(1.1, 0.95), std::pair(0.6, 1.9), std::pair(1.5, 1.4), std::pair(2.0, 0.5)}) {
    const double W = 0.5 * (l1 * l1 + l2 * l2 + 1 / (l1 * l1 * l2 * l2) - 3);
    EXPECT_NEAR(energy(l1, l2), W, 1e-14);  // round-off
  }
}

TEST(MembraneNeoHookean, UniaxialTensionLeavesTheOtherDirectionFree) {
  // lambda2 = l^(-1/2), T1 = G_s (l^3 - 1) / l^(3/2) per deformed width; dW/dlambda1 = T1 lambda2.
  for (const double l : {0.7, 1.0, 1.3, 2.0, 3.0}) {
    const double l2 = 1 / std::sqrt(l);
    const Slopes W = slopes(l, l2);
    EXPECT_NEAR(W.across, 0, 1e-12);
    EXPECT_NEAR(W.along / l2, (l * l * l - 1) / std::pow(l, 1.5), 1e-12);
  }
}

TEST(MembraneNeoHookean, EqualStretchingGivesIsotropicTension) {
  for (const double l : {0.8, 1.0, 1.25, 2.0}) {
    const Slopes W = slopes(l, l);
    const double tension = l - std::pow(l, -5);  // dW/dlambda1 at lambda2 = lambda1
    EXPECT_NEAR(W.along, tension, 1e-13);
    EXPECT_NEAR(W.across, tension, 1e-13);
  }
}

TEST(MembraneNeoHookean, SmallStrainModuliAreGsAndThreeGs) {
  const double e = 1e-4;
  // W = 2 G_s e^2 in pure shear, 2 K e^2 in dilation; the next order is e^3, and e / 1 = 1e-4.
  EXPECT_NEAR(energy(1 + e, 1 - e) / (2 * e * e), 1, 1e-3);
  EXPECT_NEAR(energy(1 + e, 1 + e) / (2 * e * e), 3, 1e-2);
}

TEST(MembraneNeoHookean, TinyStrainsDoNotCancel) {
  const double e = 1e-9;
  EXPECT_NEAR(energy(1 + e, 1 - e) / (2 * e * e), 1, 1e-6);  // as a difference of numbers near 3 it would be noise
}

TEST(MembraneNeoHookean, UndeformedTriangleHasExactlyNoForce) {
  const V3 u{0.1234, 0.777, -0.31}, v{-0.9, 0.3337, 0.21};
  const Metric g = metric(u, v);
  const CornerForces F = metric_forces(neo_hookean_gradient(g, reference_metric(g), 0.3), u, v);
  for (const V3 f : {F.b, F.c}) {
    EXPECT_EQ(f.x, 0);
    EXPECT_EQ(f.y, 0);
    EXPECT_EQ(f.z, 0);
  }
}

}  // namespace
}  // namespace rouleau
