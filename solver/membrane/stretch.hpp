// SPDX-License-Identifier: BSD-3-Clause
// Point forces that pull the two ends of a cell apart, as beads held by optical tweezers do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "membrane/cells.hpp"

namespace rouleau {

/// The vertices at the low and the high end of a cell along an axis: the `share` of its vertices that lies farthest out
/// (at least one), and all others as far out as the innermost of them, so that a symmetric mesh has symmetric ends.
/// Ascending indices.
std::array<std::vector<std::int32_t>, 2> end_vertices(const VectorArray& X, std::int32_t vertex_begin,
                                                      std::int32_t vertex_end, std::size_t axis, double share);

/// Holds the ends of all cells. Made once from the cells where they start: the same vertices are pulled ever after.
class Stretch {
 public:
  /// reads  start.X, start.ranges
  Stretch(const Cells& start, std::size_t axis, double share);

  /// Adds `force` along the axis to the high end of each cell and takes it from the low end, in equal parts a vertex.
  /// adds to  F   [vertices], force on the fluid
  void add(VectorArray& F, double force) const;

 private:
  std::size_t axis_;
  std::vector<std::array<std::vector<std::int32_t>, 2>> ends_;  ///< [cells]
};

}  // namespace rouleau
