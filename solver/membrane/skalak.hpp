// SPDX-License-Identifier: BSD-3-Clause
// The Skalak law of one triangle in metric form: energy and nodal forces, without roots or rotations.
//
// A triangle with the edges u = b - a, v = c - a has the metric g = (u.u, u.v; u.v, v.v); G is that of the stress-free
// triangle. The invariants of [Lehmann2020] Eq. 7 are
//   I1 = lambda1^2 + lambda2^2 - 2 = tr(G^-1 g) - 2,   I2 = lambda1^2 lambda2^2 - 1 = det g / det G - 1.
// Everything is written in the difference d = g - G, because they are small differences of numbers near one:
//   I1 = (G22 d11 + G11 d22 - 2 G12 d12) / det G,   I2 = I1 + det d / det G.
// An undeformed triangle therefore has exactly zero force.
#pragma once

#include <cmath>

#include "membrane/v3.hpp"

namespace rouleau {

struct ReferenceMetric {
  double G11, G12, G22;
  double inverse_det;  ///< 1 / det G
  double area;         ///< A0 = sqrt(det G) / 2
};

inline ReferenceMetric reference_metric(V3 u, V3 v) {
  const double G11 = dot(u, u), G12 = dot(u, v), G22 = dot(v, v);
  const double det = G11 * G22 - G12 * G12;
  return {G11, G12, G22, 1.0 / det, 0.5 * std::sqrt(det)};
}

/// The metric's change and the two invariants.
struct Strain {
  double d11, d12, d22, I1, I2;
};

inline Strain strain(V3 u, V3 v, const ReferenceMetric& G) {
  const double d11 = dot(u, u) - G.G11, d12 = dot(u, v) - G.G12, d22 = dot(v, v) - G.G22;
  const double I1 = (G.G22 * d11 + G.G11 * d22 - 2 * (G.G12 * d12)) * G.inverse_det;
  return {d11, d12, d22, I1, I1 + (d11 * d22 - d12 * d12) * G.inverse_det};
}

/// Energy of the triangle: A0 W.   [Lehmann2020] Eq. 8 in the convention kappa_S / 12
/// 2 I1 - 2 I2 is taken as -2 det d / det G, which does not cancel.
inline double skalak_energy(V3 u, V3 v, const ReferenceMetric& G, double kappa_S, double kappa_A) {
  const Strain e = strain(u, v, G);
  const double det_d = (e.d11 * e.d22 - e.d12 * e.d12) * G.inverse_det;
  return G.area * (kappa_S / 12 * (e.I1 * e.I1 - 2 * det_d) + kappa_A / 12 * (e.I2 * e.I2));
}

/// Forces on the triangle's corners b and c; that on a is minus their sum.
struct CornerForces {
  V3 b, c;
};

/// Minus the gradient of skalak_energy: with E_ij = dE/dg_ij, F_b = -(2 E11 u + E12 v), F_c = -(2 E22 v + E12 u).
inline CornerForces skalak_forces(V3 u, V3 v, const ReferenceMetric& G, double kappa_S, double kappa_A) {
  const Strain e = strain(u, v, G);
  const double weight = G.area * G.inverse_det;
  const double shear = kappa_S / 6 * weight;
  const double dilation = kappa_A / 6 * weight * e.I2;
  const double E11 = shear * (e.I1 * G.G22 - e.d22) + dilation * (e.d22 + G.G22);
  const double E22 = shear * (e.I1 * G.G11 - e.d11) + dilation * (e.d11 + G.G11);
  const double E12 = 2 * (shear * (e.d12 - e.I1 * G.G12) - dilation * (e.d12 + G.G12));
  return {-((2 * E11) * u + E12 * v), -((2 * E22) * v + E12 * u)};
}

}  // namespace rouleau
