// SPDX-License-Identifier: BSD-3-Clause
// Where the class changes along an axis.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// A point of a map with its class.
struct Classified {
  double x = 0, y = 0;
  std::string phase;  ///< croissant, slipper or undecided
};

/// At y, the class changes between the neighbours x = low and x = high.
struct Crossing {
  double y = 0, low = 0, high = 0;
};

/// For each y, from small x to large: the pairs of neighbours of which one is a croissant and the other a slipper.
/// Undecided points between them widen the pair. Points of the same x and different classes (replicas) are a crossing
/// without width. Ordered by y, then x.
[[nodiscard]] std::vector<Crossing> boundary(std::span<const Classified> points);

}  // namespace rouleau::campaign
