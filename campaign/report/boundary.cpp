// SPDX-License-Identifier: BSD-3-Clause
// A walk along each row.
#include "report/boundary.hpp"

#include <algorithm>
#include <tuple>

namespace rouleau::campaign {

std::vector<Crossing> boundary(std::span<const Classified> points) {
  std::vector<Classified> decided;
  for (const Classified& point : points) {
    if (point.phase == "croissant" || point.phase == "slipper") decided.push_back(point);
  }
  std::sort(decided.begin(), decided.end(), [](const Classified& a, const Classified& b) {
    return std::tie(a.y, a.x, a.phase) < std::tie(b.y, b.x, b.phase);
  });
  std::vector<Crossing> crossings;
  for (std::size_t i = 1; i < decided.size(); ++i) {
    const Classified &before = decided[i - 1], &here = decided[i];
    if (before.y == here.y && before.phase != here.phase) crossings.push_back({here.y, before.x, here.x});
  }
  return crossings;
}

}  // namespace rouleau::campaign
