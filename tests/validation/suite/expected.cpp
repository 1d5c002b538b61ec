// SPDX-License-Identifier: BSD-3-Clause
#include "expected.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rouleau::validation {

bool Expected::holds(double ours) const { return std::abs(ours - reference) <= tolerance; }

Expected near(double reference, double tolerance) {
  return {reference, tolerance, fmt::format("{:.7g} ± {:.2g}", reference, tolerance)};
}

Expected near_relative(double reference, double share) {
  return {reference, share * std::abs(reference), fmt::format("{:.7g} ± {:.2g} %", reference, 100 * share)};
}

Expected between(double low, double high) {
  return {0.5 * (low + high), 0.5 * (high - low), fmt::format("{:.6g} … {:.6g}", low, high)};
}

Expected at_most(double limit) { return {0, limit, fmt::format("0 ± {:.2g}", limit)}; }

}  // namespace rouleau::validation
