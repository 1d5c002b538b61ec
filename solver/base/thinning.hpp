// SPDX-License-Identifier: BSD-3-Clause
// Every n-th node of a lattice: those whose global coordinates are multiples of n, as a lattice of their own.
#pragma once

#include "base/grid.hpp"

namespace rouleau {

/// Multiples of `stride` in [0, n).
constexpr int thinned(int n, int stride) { return (n + stride - 1) / stride; }

inline Int3 thinned(const Int3& size, int stride) {
  return {thinned(size[0], stride), thinned(size[1], stride), thinned(size[2], stride)};
}

/// What is left of a block, in coordinates of the thinned lattice; may be empty. Blocks that partition a lattice leave
/// blocks that partition the thinned one.
inline Block thinned(const Block& block, int stride) {
  Block left;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    left.begin[axis] = thinned(block.begin[axis], stride);
    left.size[axis] = thinned(block.begin[axis] + block.size[axis], stride) - left.begin[axis];
  }
  return left;
}

/// Calls `visit(i, j, k)` with the local coordinates of the nodes of a block that are left, x fastest.
template <class Visit>
void each_thinned_node(const Block& block, int stride, const Visit& visit) {
  const Block left = thinned(block, stride);
  const auto local = [&](std::size_t axis, int n) { return (left.begin[axis] + n) * stride - block.begin[axis]; };
  for (int k = 0; k < left.size[2]; ++k)
    for (int j = 0; j < left.size[1]; ++j)
      for (int i = 0; i < left.size[0]; ++i) visit(local(0, i), local(1, j), local(2, k));
}

}  // namespace rouleau
