// SPDX-License-Identifier: BSD-3-Clause
// Helfrich bending by the cotangent Laplacian and Voronoi areas ("method B"), as sums over triangles.
//
// [Lehmann2020] Eqs. 9-13. With the vertex sums over neighbours j
//   L_i = sum_j (cot theta_1 + cot theta_2) (x_i - x_j),   A_i = 1/8 sum_j (cot theta_1 + cot theta_2) |x_i - x_j|^2
// (the print of Eq. 13 lost the square) the Laplacian is L_i / (2 A_i), its length is 2 |H|, and Eq. 10 becomes
//   E = kappa_B/2 sum_i (2 H_i)^2 A_i = kappa_B/8 sum_i |L_i|^2 / A_i.
// Obtuse triangles are taken as the formula says. The gradient is exact: with p_i = L_i / A_i and s_i = |p_i|^2,
//   dE = kappa_B/8 sum_i (2 p_i . dL_i - s_i dA_i),
// which again is a sum over triangles, given p and s at the three corners.
#pragma once

#include <cmath>

#include "membrane/skalak.hpp"
#include "membrane/v3.hpp"

namespace rouleau {

/// Cotangents of the corner angles. Edge bc faces corner a, and so on.
struct Cotangents {
  double a, b, c;
  V3 normal;            ///< of unit length, outward
  double inverse_area;  ///< 1 / (2 A)
};

/// u = b - a, v = c - a.
inline Cotangents cotangents(V3 u, V3 v) {
  const V3 w = v - u;
  const V3 N = cross(u, v);
  const double inverse = 1.0 / std::sqrt(dot(N, N));
  return {dot(u, v) * inverse, -dot(u, w) * inverse, dot(v, w) * inverse, inverse * N, inverse};
}

/// What one triangle adds to L and A of its corners.
struct CornerCurvatures {
  V3 L_a, L_b, L_c;
  double A_a, A_b, A_c;
};

inline CornerCurvatures corner_curvatures(V3 u, V3 v) {
  const V3 w = v - u;
  const Cotangents cot = cotangents(u, v);
  const V3 along_u = cot.c * u, along_v = cot.b * v, along_w = cot.a * w;
  const double area_u = 0.125 * dot(along_u, u), area_v = 0.125 * dot(along_v, v), area_w = 0.125 * dot(along_w, w);
  return {-(along_u + along_v), along_u - along_w, along_v + along_w,
          area_u + area_v,      area_u + area_w,   area_v + area_w};
}

/// p = L / A and s = p.p of a vertex.
struct VertexCurvature {
  V3 p;
  double s;
};

inline VertexCurvature vertex_curvature(V3 L, double A) {
  const V3 p = (1.0 / A) * L;
  return {p, dot(p, p)};
}

/// Bending energy of a vertex.
inline double bending_energy(V3 L, double A, double kappa_B) { return kappa_B / 8 * (dot(L, L) / A); }

/// The part of -dE/dX that one triangle gives to its corners b and c; that on a is minus their sum.
///
/// Let e run over the edges: d_e the edge, cot_e that of the corner facing it, dp_e the difference of p along the edge,
/// sigma_e the sum of s over its ends, q_e = 2 dp_e . d_e - sigma_e |d_e|^2 / 8. The triangle's share of dE is
///   kappa_B/8 sum_e [q_e d(cot_e) + cot_e (2 dp_e - sigma_e d_e / 4) . d(d_e)].
inline CornerForces bending_forces(V3 u, V3 v, const VertexCurvature& a, const VertexCurvature& b,
                                   const VertexCurvature& c, double kappa_B) {
  const V3 w = v - u;
  const Cotangents cot = cotangents(u, v);
  const V3 dp_u = b.p - a.p, dp_v = c.p - a.p, dp_w = c.p - b.p;
  const double sigma_u = a.s + b.s, sigma_v = a.s + c.s, sigma_w = b.s + c.s;
  const double q_u = 2 * dot(dp_u, u) - 0.125 * sigma_u * dot(u, u);
  const double q_v = 2 * dot(dp_v, v) - 0.125 * sigma_v * dot(v, v);
  const double q_w = 2 * dot(dp_w, w) - 0.125 * sigma_w * dot(w, w);
  const V3 t_u = cot.c * (2 * dp_u - (0.25 * sigma_u) * u);
  const V3 t_v = cot.b * (2 * dp_v - (0.25 * sigma_v) * v);
  const V3 t_w = cot.a * (2 * dp_w - (0.25 * sigma_w) * w);
  // cot_a = u.v / D, cot_b = -u.w / D, cot_c = v.w / D with D = |u x v|; dD = du . (v x n) + dv . (n x u).
  const double k_a = q_w * cot.inverse_area, k_b = q_v * cot.inverse_area, k_c = q_u * cot.inverse_area;
  const double k_D = (q_w * cot.a + q_v * cot.b + q_u * cot.c) * cot.inverse_area;
  const V3 gradient_u = t_u - t_w + (k_a - k_c) * v + k_b * (u - w) - k_D * cross(v, cot.normal);
  const V3 gradient_v = t_v + t_w + (k_a - k_b) * u + k_c * (v + w) - k_D * cross(cot.normal, u);
  return {(-kappa_B / 8) * gradient_u, (-kappa_B / 8) * gradient_v};
}

}  // namespace rouleau
