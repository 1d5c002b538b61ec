// SPDX-License-Identifier: BSD-3-Clause
// The Skalak law of one triangle in metric form: energy and nodal forces, without roots or rotations.
#pragma once

#include "base/simd.hpp"
#include "membrane/strain.hpp"

namespace rouleau {

/// Energy of the triangle: A0 W.   [Lehmann2020] Eq. 8 in the convention kappa_S / 12
/// 2 I1 - 2 I2 is taken as -2 det d / det G, which does not cancel.
inline double skalak_energy(const Metric& g, const ReferenceMetric& G, double kappa_S, double kappa_A) {
  const Strain e = strain(g, G);
  const double det_d = determinant_of_change(e, G);
  return G.area * (kappa_S / 12 * (e.I1 * e.I1 - 2 * det_d) + kappa_A / 12 * (e.I2 * e.I2));
}

/// Derivatives of skalak_energy by the metric g. An undeformed triangle has exactly zero force.
ROW_INLINE inline MetricGradient skalak_gradient(const Metric& g, const ReferenceMetric& reference, double kappa_S,
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
