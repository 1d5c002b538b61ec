// SPDX-License-Identifier: BSD-3-Clause
// Helfrich bending by the cotangent Laplacian and Voronoi areas ("method B"), as sums over triangles.
//
// [Lehmann2020] Eqs. 9-13. With the vertex sums over neighbours j
//   L_i = sum_j (cot theta_1 + cot theta_2) (x_i - x_j),   A_i = 1/8 sum_j (cot theta_1 + cot theta_2) |x_i - x_j|^2
// (the print of Eq. 13 lost the square) the Laplacian is L_i / (2 A_i), its length is 2 |H|, and Eq. 10 becomes
//   E = kappa_B/2 sum_i (2 H_i)^2 A_i = kappa_B/8 sum_i |L_i|^2 / A_i.
// Obtuse triangles are taken as the formula says. The gradient is exact: with P_i = kappa_B/4 L_i / A_i and
// S_i = kappa_B/64 |L_i / A_i|^2,
//   dE = sum_i (P_i . dL_i - 8 S_i dA_i),
// which again is a sum over triangles, given P and S at the three corners.
//
// A triangle's angles follow from its metric g: with D = sqrt(det g) = 2 A,
//   cot_a = g12 / D,   cot_b = (g11 - g12) / D,   cot_c = (g22 - g12) / D.
#pragma once

#include <cmath>

#include "base/simd.hpp"
#include "membrane/metric.hpp"
#include "membrane/v3.hpp"

namespace rouleau {

/// Cotangents of the corner angles. Edge bc faces corner a, and so on.
struct Cotangents {
  double a, b, c;
  double inverse_D;  ///< 1 / (2 A)
};

inline Cotangents cotangents(const Metric& g) {
  const double inverse = 1.0 / std::sqrt(determinant(g));
  return {g.g12 * inverse, (g.g11 - g.g12) * inverse, (g.g22 - g.g12) * inverse, inverse};
}

/// What one triangle adds to L and A of its corners.
struct CornerCurvatures {
  V3 L_a, L_b, L_c;
  double A_a, A_b, A_c;
};

inline CornerCurvatures corner_curvatures(V3 u, V3 v) {
  const Metric g = metric(u, v);
  const Cotangents cot = cotangents(g);
  // L_b = cot_c u - cot_a (v - u), and cot_c + cot_a = g22 / D; L_c likewise.
  const V3 L_b = fused(g.g22 * cot.inverse_D, u, -cot.a * v), L_c = fused(g.g11 * cot.inverse_D, v, -cot.a * u);
  const double area_u = 0.125 * cot.c * g.g11, area_v = 0.125 * cot.b * g.g22;
  const double area_w = 0.125 * cot.a * ((g.g11 - g.g12) + (g.g22 - g.g12));
  return {-(L_b + L_c), L_b, L_c, area_u + area_v, area_u + area_w, area_v + area_w};
}

/// P and S of a vertex.
struct VertexCurvature {
  V3 P;
  double S;
};

inline VertexCurvature vertex_curvature(V3 L, double A, double kappa_B) {
  const V3 p = (1.0 / A) * L;
  return {kappa_B / 4 * p, kappa_B / 64 * fused_dot(p, p)};
}

/// Bending energy of a vertex.
inline double bending_energy(V3 L, double A, double kappa_B) { return kappa_B / 8 * (dot(L, L) / A); }

/// A triangle's share of dE: by its metric, and by its edges at fixed metric.
struct BendingGradient {
  MetricGradient by_metric;
  V3 by_u, by_v;
};

/// The triangle's share of E at fixed P and S is sum_e cot_e q_e over its edges e: d_e the edge, cot_e that of the
/// corner facing it, dP_e the difference of P along it, sigma_e the sum of S over its ends,
///   q_e = dP_e . d_e - sigma_e |d_e|^2.
/// With h = q_w - q_u - q_v for the third edge w = v - u, it is T = (q_u g22 + q_v g11 + h g12) / D.
ROW_INLINE inline BendingGradient bending_gradient(const Metric& g, V3 u, V3 v, const VertexCurvature& a,
                                                   const VertexCurvature& b, const VertexCurvature& c) {
  const Cotangents cot = cotangents(g);
  const V3 dP_u = b.P - a.P, dP_v = c.P - a.P;
  const double sigma_u = a.S + b.S, sigma_v = a.S + c.S, sigma_w = b.S + c.S;
  const double length2_w = (g.g11 - g.g12) + (g.g22 - g.g12);
  const double q_u = std::fma(-sigma_u, g.g11, fused_dot(dP_u, u));
  const double q_v = std::fma(-sigma_v, g.g22, fused_dot(dP_v, v));
  const double q_w = std::fma(-sigma_w, length2_w, fused_dot(dP_v - dP_u, v - u));
  const double h = q_w - q_u - q_v;
  const double i = cot.inverse_D;
  const double half_T_over_det = 0.5 * (i * i * i) * std::fma(q_u, g.g22, std::fma(q_v, g.g11, h * g.g12));
  const double k_u = sigma_u * cot.c, k_v = sigma_v * cot.b, k_w = sigma_w * cot.a;
  const double stretch_u = g.g22 * i, stretch_v = g.g11 * i;
  return {{std::fma(q_v, i, std::fma(-half_T_over_det, g.g22, -(k_u + k_w))),
           std::fma(h, i, 2 * std::fma(half_T_over_det, g.g12, k_w)),
           std::fma(q_u, i, std::fma(-half_T_over_det, g.g11, -(k_v + k_w)))},
          fused(stretch_u, dP_u, -cot.a * dP_v),
          fused(stretch_v, dP_v, -cot.a * dP_u)};
}

}  // namespace rouleau
