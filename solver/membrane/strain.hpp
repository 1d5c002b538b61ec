// SPDX-License-Identifier: BSD-3-Clause
// How far a triangle is strained: its metric against that of the stress-free triangle, and the two invariants.
//
// A triangle with the edges u = b - a, v = c - a has the metric g = (u.u, u.v; u.v, v.v); G is that of the stress-free
// triangle. The invariants of [Lehmann2020] Eq. 7 are
//   I1 = lambda1^2 + lambda2^2 - 2 = tr(G^-1 g) - 2,   I2 = lambda1^2 lambda2^2 - 1 = det g / det G - 1.
// Everything is written in the difference d = g - G, because they are small differences of numbers near one:
//   I1 = (G22 d11 + G11 d22 - 2 G12 d12) / det G,   I2 = I1 + det d / det G.
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

/// det d / det G = I2 - I1, without the cancellation.
inline double determinant_of_change(const Strain& e, const ReferenceMetric& G) {
  return (e.d11 * e.d22 - e.d12 * e.d12) * G.inverse_det;
}

}  // namespace rouleau
