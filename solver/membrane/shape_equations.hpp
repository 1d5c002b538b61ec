// SPDX-License-Identifier: BSD-3-Clause
// The equations of the analytic shapes: what lies inside a sphere, an ellipsoid, a red blood cell.
//
// [Lehmann2020] Lehmann, Mueller, Gekle, Int J Numer Meth Fluids 2020, doi 10.1002/fld.4835. Every shape is centred at
// the origin; the red blood cell's disc axis is z.
#pragma once

#include "base/vec3.hpp"

namespace rouleau {

/// Coefficients of Eq. 14, divided by the large radius R.
inline constexpr double red_blood_cell_c0 = 0.207;
inline constexpr double red_blood_cell_c2 = 2.00;
inline constexpr double red_blood_cell_c4 = 1.12;

/// The bracket of Eq. 15 divided by R, for r2 = (x^2 + y^2) / R^2.
/// The half thickness is R/2 times this times sqrt(1 - r2).
constexpr double red_blood_cell_profile(double r2) {
  return red_blood_cell_c0 + (red_blood_cell_c2 - red_blood_cell_c4 * r2) * r2;
}

/// Eqs. 0, 14 and 15; points of the surface count as inside. `R` in the unit of `point`.
inline bool inside_red_blood_cell(const Vec3& point, double R) {
  const double r2 = (point[0] * point[0] + point[1] * point[1]) / (R * R);
  if (r2 > 1) return false;
  const double profile = R * red_blood_cell_profile(r2);
  return point[2] * point[2] <= 0.25 * profile * profile * (1 - r2);
}

/// Points of the surface count as inside. `semi_axes` in the unit of `point`.
inline bool inside_ellipsoid(const Vec3& point, const Vec3& semi_axes) {
  return point.cwiseQuotient(semi_axes).squaredNorm() <= 1;
}

/// Eq. 0.
inline bool inside_sphere(const Vec3& point, double radius) { return point.squaredNorm() <= radius * radius; }

}  // namespace rouleau
