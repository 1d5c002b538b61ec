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

#include "membrane/metric.hpp"

namespace rouleau {

struct ReferenceMetric {
  Metric G;
  double inverse_det;  ///< 1 / det G
  double area;         ///< A0 = sqrt(det G) / 2
};

inline ReferenceMetric reference_metric(const Metric& G) {
  const double det = determinant(G);
  return {G, 1.0 / det, 0.5 * std::sqrt(det)};
}

/// The metric's change and the two invariants.
struct Strain {
  double d11, d12, d22, I1, I2;
};

inline Strain strain(const Metric& g, const ReferenceMetric& reference) {
  const Metric& G = reference.G;
  const Metric d{g.g11 - G.g11, g.g12 - G.g12, g.g22 - G.g22};
  const double I1 = std::fma(G.g22, d.g11, std::fma(G.g11, d.g22, -2 * (G.g12 * d.g12))) * reference.inverse_det;
  return {d.g11, d.g12, d.g22, I1, std::fma(determinant(d), reference.inverse_det, I1)};
}

/// Energy of the triangle: A0 W.   [Lehmann2020] Eq. 8 in the convention kappa_S / 12
/// 2 I1 - 2 I2 is taken as -2 det d / det G, which does not cancel.
inline double skalak_energy(const Metric& g, const ReferenceMetric& G, double kappa_S, double kappa_A) {
  const Strain e = strain(g, G);
  const double det_d = (e.d11 * e.d22 - e.d12 * e.d12) * G.inverse_det;
  return G.area * (kappa_S / 12 * (e.I1 * e.I1 - 2 * det_d) + kappa_A / 12 * (e.I2 * e.I2));
}

/// Derivatives of skalak_energy by the metric g.
inline MetricGradient skalak_gradient(const Metric& g, const ReferenceMetric& reference, double kappa_S,
                                      double kappa_A) {
  const Strain e = strain(g, reference);
  const Metric& G = reference.G;
  const double weight = reference.area * reference.inverse_det;
  const double shear = kappa_S / 6 * weight;
  const double dilation = kappa_A / 6 * weight * e.I2;
  // d of det g = adj g . dg, where adj g = (g22, -g12; -g12, g11)
  return {std::fma(shear, std::fma(e.I1, G.g22, -e.d22), dilation * g.g22),
          2 * std::fma(shear, std::fma(-e.I1, G.g12, e.d12), -dilation * g.g12),
          std::fma(shear, std::fma(e.I1, G.g11, -e.d11), dilation * g.g11)};
}

}  // namespace rouleau
