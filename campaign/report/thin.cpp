// SPDX-License-Identifier: BSD-3-Clause
// Extremes of equally long stretches.
#include "report/thin.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::campaign {

std::vector<std::size_t> thinned(std::span<const double> values, std::size_t most) {
  std::vector<std::size_t> kept;
  if (values.size() <= most) {
    kept.resize(values.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  const std::size_t stretches = (std::max<std::size_t>(most, 4) - 2) / 2, inner = values.size() - 2;
  kept.push_back(0);
  for (std::size_t s = 0; s < stretches; ++s) {
    const std::size_t begin = 1 + inner * s / stretches, end = 1 + inner * (s + 1) / stretches;
    std::size_t low = begin, high = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (!std::isfinite(values[i])) continue;
      if (!std::isfinite(values[low]) || values[i] < values[low]) low = i;
      if (!std::isfinite(values[high]) || values[i] > values[high]) high = i;
    }
    kept.push_back(std::min(low, high));
    if (low != high) kept.push_back(std::max(low, high));
  }
  kept.push_back(values.size() - 1);
  return kept;
}

std::vector<std::size_t> spread_evenly(std::span<const double> positions, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (positions.empty()) return chosen;
  if (most <= 1) return {positions.size() - 1};
  const std::size_t count = std::min(most, positions.size());
  for (std::size_t k = 0; k < count; ++k) {
    const double share = count == 1 ? 1.0 : static_cast<double>(k) / static_cast<double>(count - 1);
    const double wanted = positions.front() + share * (positions.back() - positions.front());
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < positions.size(); ++i)
      if (std::abs(positions[i] - wanted) < std::abs(positions[nearest] - wanted)) nearest = i;
    if (chosen.empty() || nearest > chosen.back()) chosen.push_back(nearest);
  }
  return chosen;
}

}  // namespace rouleau::campaign
