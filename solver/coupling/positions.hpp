// SPDX-License-Identifier: BSD-3-Clause
// Where a vertex may be: finite, and between the walls.
#pragma once

#include <algorithm>

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// Lowest and highest position along an axis: the walls, or along a periodic axis what an int can count.
struct PositionRange {
  double low, high;
  PositionRange(const Lattice& lattice, int axis) {
    constexpr double far = 1 << 30;
    low = lattice.periodic[axis] ? -far : -0.5;
    high = lattice.periodic[axis] ? far : lattice.size[axis] - 0.5;
  }
  /// False for anything that is not a number, too.
  [[nodiscard]] bool contains(double X) const { return X >= low && X <= high; }
  /// X itself if it is in the range; its low end for anything that is not a number.
  [[nodiscard]] double nearest(double X) const { return std::min(high, std::max(low, X)); }
};

/// Throws Error(physics) for the lowest vertex outside of its range; returns if there is none.
void check_positions(const Cells& cells, const Lattice& lattice);

}  // namespace rouleau
