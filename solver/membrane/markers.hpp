// SPDX-License-Identifier: BSD-3-Clause
// Two material points of a membrane by which its tank-treading is seen.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau {

/// Vertices of one cell: those which lie nearest to the directions +y and +z from the centre of its volume at the
/// start. In a flow along x one of them is carried around when the membrane tank-treads in the x-y or the x-z plane.
struct Markers {
  std::int32_t y = 0, z = 0;
};

/// reads  cells.X, cells.ranges, cells.triangles
/// Of several vertices equally near the first is taken.
Markers choose_markers(const Cells& start, std::size_t cell);

}  // namespace rouleau
