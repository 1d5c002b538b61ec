// SPDX-License-Identifier: BSD-3-Clause
// Two material points of a membrane by which its tank-treading is seen.
#include "membrane/markers.hpp"

#include "membrane/measures.hpp"

namespace rouleau {
namespace {

std::int32_t nearest_to_direction(const VectorArray& X, const CellRange& range, const Vec3& centre, int axis) {
  std::int32_t nearest = range.vertex_begin;
  double largest_cosine = -2;
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    const double cosine = (at(X, static_cast<std::size_t>(v)) - centre).normalized()[axis];
    if (cosine <= largest_cosine) continue;
    largest_cosine = cosine;
    nearest = v;
  }
  return nearest;
}

}  // namespace

Markers choose_markers(const Cells& start, std::size_t cell) {
  const Vec3 centre = centre_of_mass(start, cell);
  const CellRange& range = start.ranges[cell];
  return {nearest_to_direction(start.X, range, centre, 1), nearest_to_direction(start.X, range, centre, 2)};
}

}  // namespace rouleau
