// SPDX-License-Identifier: BSD-3-Clause
// The nodes of a block that lie in a box of periodic space: each node once for each of its images in the box.
#pragma once

#include <cmath>

#include "base/grid.hpp"

namespace rouleau {

/// An axis-parallel box, borders included; may reach over periodic borders.
struct ImageBox {
  Vec3 low, high;
};

/// Calls visit(i, j, k, position) with a node's local coordinates in the block and its image's position in the box.
template <class Visit>
void for_each_image(const ImageBox& box, const Lattice& lattice, const Block& block, Visit visit) {
  const auto first = [&](int axis) { return static_cast<int>(std::ceil(box.low[axis])); };
  const auto last = [&](int axis) { return static_cast<int>(std::floor(box.high[axis])); };
  // Beyond a wall the coordinate stays unfolded, and so falls outside every block.
  const auto local = [&](int axis, int node) { return lattice.wrap(axis, node) - block.begin[axis]; };
  const auto is_owned = [&](int axis, int l) { return l >= 0 && l < block.size[axis]; };
  for (int z = first(2); z <= last(2); ++z) {
    const int k = local(2, z);
    if (!is_owned(2, k)) continue;
    for (int y = first(1); y <= last(1); ++y) {
      const int j = local(1, y);
      if (!is_owned(1, j)) continue;
      for (int x = first(0); x <= last(0); ++x) {
        const int i = local(0, x);
        if (is_owned(0, i)) visit(i, j, k, Vec3(x, y, z));
      }
    }
  }
}

}  // namespace rouleau
