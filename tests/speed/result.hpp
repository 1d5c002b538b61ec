// SPDX-License-Identifier: BSD-3-Clause
// From the measured figures to those asked for, as JSON and as tables.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "series.hpp"

namespace rouleau::speed {

/// What the figures refer to.
struct PointFacts {
  std::int64_t nodes = 0, vertices = 0, triangles = 0;
  std::int64_t steps = 0, steps_large = 0;  ///< of the paper's point, and at the large time step
};

/// Adds ratios, shares and core-hours to what was measured.
void derive_figures(Series& series, const PointFacts& point);

/// Each figure's median by its name; those with dots in their names nested; then `spread`, `targets`, `point`.
nlohmann::ordered_json result_json(const Series& series, const PointFacts& point);

}  // namespace rouleau::speed
