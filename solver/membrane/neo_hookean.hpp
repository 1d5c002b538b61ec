// SPDX-License-Identifier: BSD-3-Clause
// The neo-Hookean law of one triangle in metric form: an incompressible sheet that thins where it is stretched.
//
//   W = G_s/2 (lambda1^2 + lambda2^2 + 1 / (lambda1 lambda2)^2 - 3) = G_s/2 (I1 + 1 / (1 + I2) - 1),   G_s = kappa_S /
//   3 [Ramanujan, Pozrikidis 1998; Barthes-Biesel et al. 2002]
// For small strains its shear modulus is G_s and its area modulus 3 G_s: the same as Skalak's with C = 1.
#pragma once

#include "base/simd.hpp"
#include "membrane/strain.hpp"

namespace rouleau {

/// Energy of the triangle: A0 W. I1 + 1 / (1 + I2) - 1 is taken as (I1 I2 - det d / det G) / (1 + I2), which does not
/// cancel.
inline double neo_hookean_energy(const Metric& g, const ReferenceMetric& G, double kappa_S) {
  const Strain e = strain(g, G);
  return G.area * (kappa_S / 6) * ((e.I1 * e.I2 - determinant_of_change(e, G)) / (1 + e.I2));
}

/// Derivatives of neo_hookean_energy by the metric g. With s = 1 / (1 + I2)^2 it is G_s/2 A0 / det G (adj G - s adj g);
/// adj G - s adj g is taken as s (I2 (2 + I2) adj G - adj d), so that an undeformed triangle has exactly zero force.
ROW_INLINE inline MetricGradient neo_hookean_gradient(const Metric& g, const ReferenceMetric& reference,
                                                      double kappa_S) {
  const Strain e = strain(g, reference);
  const Metric& G = reference.G;
  const double inverse = 1 / (1 + e.I2);
  const double shear = kappa_S / 6 * (reference.area * reference.inverse_det) * (inverse * inverse);
  const double thinning = e.I2 * (2 + e.I2);
  return {shear * std::fma(thinning, G.g22, -e.d22), 2 * (shear * std::fma(-thinning, G.g12, e.d12)),
          shear * std::fma(thinning, G.g11, -e.d11)};
}

}  // namespace rouleau
