// SPDX-License-Identifier: BSD-3-Clause
// The figures that the project has set itself. Missing one is news, not a failure.
#pragma once

#include <string>
#include <vector>

#include "series.hpp"

namespace rouleau::speed {

struct Target {
  std::string figure;
  double low, high;  ///< reached within [low, high]
  double value;
  std::string text;  ///< ">= 0.55"
  [[nodiscard]] bool is_reached() const { return value >= low && value <= high; }
};

/// Those whose figures were measured.
std::vector<Target> targets(const Series& series);

}  // namespace rouleau::speed
