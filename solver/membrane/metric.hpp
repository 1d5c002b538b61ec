// SPDX-License-Identifier: BSD-3-Clause
// The metric of a triangle, from which both laws are written, and the forces of an energy that depends on it.
#pragma once

#include <cmath>

#include "membrane/v3.hpp"

namespace rouleau {

/// Of the edges u = b - a and v = c - a of a triangle a, b, c: u.u, u.v, v.v.
struct Metric {
  double g11, g12, g22;
};

inline Metric metric(V3 u, V3 v) { return {fused_dot(u, u), fused_dot(u, v), fused_dot(v, v)}; }

/// (2 A)^2
inline double determinant(const Metric& g) { return std::fma(g.g11, g.g22, -(g.g12 * g.g12)); }

/// Derivatives of an energy by g11, g12 and g22.
struct MetricGradient {
  double E11, E12, E22;
};

inline MetricGradient operator+(const MetricGradient& a, const MetricGradient& b) {
  return {a.E11 + b.E11, a.E12 + b.E12, a.E22 + b.E22};
}

/// Forces on the triangle's corners b and c; that on a is minus their sum.
struct CornerForces {
  V3 b, c;
};

/// Minus the gradient: F_b = -(2 E11 u + E12 v), F_c = -(2 E22 v + E12 u).
inline CornerForces metric_forces(const MetricGradient& E, V3 u, V3 v) {
  return {fused(-2 * E.E11, u, -E.E12 * v), fused(-2 * E.E22, v, -E.E12 * u)};
}

}  // namespace rouleau
