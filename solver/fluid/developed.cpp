// SPDX-License-Identifier: BSD-3-Clause
// Series of the laminar channel flow.
#include "fluid/developed.hpp"

#include <limits>
#include <numbers>

#include "base/error.hpp"

namespace rouleau {

namespace {

constexpr double pi = std::numbers::pi;

/// cosh(s) / cosh(t) for 0 <= s <= t, t possibly infinite, without overflow.
double cosh_ratio(double s, double t) { return std::exp(s - t) * (1 + std::exp(-2 * s)) / (1 + std::exp(-2 * t)); }

/// Parabola over the shorter side 2a minus the series of what the walls of the longer side 2b hold back.
/// Terms fall like exp(-n pi (b - z) / 2a) / n^3, alternating: summed until they no longer count.
double series(double y, double z, double a, double b) {
  const double parabola = (a * a - y * y) / 2;
  if (std::isinf(b)) return parabola;
  double sum = 0;
  for (int n = 1; n < 100001; n += 2) {
    const double size = cosh_ratio(n * pi * z / (2 * a), n * pi * b / (2 * a)) / (double(n) * n * n);
    sum += (n % 4 == 1 ? size : -size) * std::cos(n * pi * y / (2 * a));
    if (size < 1e-18) break;
  }
  return parabola - 16 * a * a / (pi * pi * pi) * sum;
}

double mean_of(double a, double b) {
  double sum = 0;
  for (int n = 1; n < 2001; n += 2) sum += std::tanh(n * pi * b / (2 * a)) / std::pow(n, 5);
  return a * a / 3 * (1 - 192 * a / (std::pow(pi, 5) * b) * sum);
}

double width(const Lattice& lattice, int axis) {
  return lattice.periodic[axis] ? std::numeric_limits<double>::infinity() : lattice.size[axis];
}

}  // namespace

DevelopedFlow::DevelopedFlow(double width_y, double width_z) : width_y_(width_y), width_z_(width_z), mean_(0) {
  const double shorter = std::min(width_y, width_z), longer = std::max(width_y, width_z);
  if (!(shorter > 0 && std::isfinite(shorter)))
    fail(Exit::bad_input,
         "channel is {} x {} nodes wide: a force along x has no steady flow without walls in y or z. Give it walls.",
         width_y, width_z);
  mean_ = mean_of(shorter / 2, longer / 2);
}

DevelopedFlow::DevelopedFlow(const Lattice& lattice) : DevelopedFlow(width(lattice, 1), width(lattice, 2)) {}

double DevelopedFlow::velocity(double y, double z) const {
  const double abs_y = std::abs(y), abs_z = std::abs(z);
  return width_y_ < width_z_ ? series(abs_y, abs_z, width_y_ / 2, width_z_ / 2)
                             : series(abs_z, abs_y, width_z_ / 2, width_y_ / 2);
}

}  // namespace rouleau
