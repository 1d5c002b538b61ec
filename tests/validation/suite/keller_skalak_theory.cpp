// SPDX-License-Identifier: BSD-3-Clause
#include "keller_skalak_theory.hpp"

#include <cmath>

namespace rouleau::validation {

namespace {

/// int_0^inf ds / ((p + s)(q + s) sqrt((p + s)(q + s)(t + s))) by the midpoint rule in x, s = (x/(1 - x))^2: the
/// integrand vanishes at both ends.
double shape_integral(double p, double q, double t) {
  constexpr int intervals = 20000;
  double sum = 0;
  for (int i = 0; i < intervals; ++i) {
    const double x = (i + 0.5) / intervals, ratio = x / (1 - x), s = ratio * ratio;
    const double ds_dx = 2 * ratio / ((1 - x) * (1 - x));
    sum += ds_dx / ((p + s) * (q + s) * std::sqrt((p + s) * (q + s) * (t + s)));
  }
  return sum / intervals;
}

}  // namespace

KellerSkalak::KellerSkalak(const Vec3& semi_axes) : r_(semi_axes[1] / semi_axes[0]) {
  const Vec3 A = semi_axes / std::cbrt(semi_axes.prod());
  const Vec3 squares = A.cwiseProduct(A);
  const double z1 = 0.5 * (1 / r_ - r_);
  const double z2 = (squares[0] + squares[1]) * shape_integral(squares[0], squares[1], squares[2]);
  f1_ = 4 * z1 * z1;
  f2_ = 4 * z1 * z1 * (1 - 2 / z2);
  f3_ = -4 * z1 / z2;
}

double KellerSkalak::cosine_of_twice_the_angle(double lambda) const {
  const double sum = 1 + r_ * r_;
  return 0.5 / ((1 - r_ * r_) / (2 * sum) + 2 * r_ * K(lambda) / sum);
}

std::optional<KellerSkalak::Steady> KellerSkalak::steady(double lambda) const {
  const double cosine = cosine_of_twice_the_angle(lambda);
  if (cosine > 1) return std::nullopt;
  return Steady{0.5 * std::acos(cosine), K(lambda) * cosine};
}

double KellerSkalak::critical_lambda() const {
  // cos 2 theta = 1:  2 r K / (1 + r^2) = 1/2 - (1 - r^2)/(2 (1 + r^2)) = r^2/(1 + r^2), hence K = r/2.
  return (f2_ - 2 * f3_ / r_) / f1_;
}

}  // namespace rouleau::validation
