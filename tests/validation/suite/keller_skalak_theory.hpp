// SPDX-License-Identifier: BSD-3-Clause
// The tank-treading ellipsoid of Keller and Skalak: a membrane that flows around a shape which does not change.
#pragma once

#include <optional>

#include "base/vec3.hpp"

namespace rouleau::validation {

/// An ellipsoid in shear flow: semi-axes a1, a2 in the shear plane, a1 the longer, and a3 along the vorticity; any
/// unit. With r = a2/a1, gamma the shear rate, theta the angle of a1 to the flow and w the angular rate of the
/// membrane,
///   theta' = -gamma/2 - 2 r/(1 + r^2) w + gamma/2 (1 - r^2)/(1 + r^2) cos 2 theta,   w = -gamma K cos 2 theta,
///   K = f3/(f2 - lambda f1), f1 = 4 z1^2, f2 = 4 z1^2 (1 - 2/z2), f3 = -4 z1/z2, z1 = (1/r - r)/2,
///   z2 = (A1^2 + A2^2) int_0^inf ds / ((A1^2 + s)(A2^2 + s) sqrt((A1^2 + s)(A2^2 + s)(A3^2 + s))),
///   A_i = a_i / (a1 a2 a3)^(1/3).   [Keller, Skalak 1982]
class KellerSkalak {
 public:
  explicit KellerSkalak(const Vec3& semi_axes);

  struct Steady {
    double angle_rad;
    double membrane_rate;  ///< |w| / gamma
  };
  /// Where theta' = 0; none: the ellipsoid tumbles.
  [[nodiscard]] std::optional<Steady> steady(double lambda) const;
  /// The viscosity contrast at which it begins to tumble.
  [[nodiscard]] double critical_lambda() const;

 private:
  [[nodiscard]] double K(double lambda) const { return f3_ / (f2_ - lambda * f1_); }
  [[nodiscard]] double cosine_of_twice_the_angle(double lambda) const;

  double r_, f1_, f2_, f3_;
};

}  // namespace rouleau::validation
