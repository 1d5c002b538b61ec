// SPDX-License-Identifier: BSD-3-Clause
// Cutting a lattice into blocks by hand, without MPI: the oracle for "the result does not depend on the cut".
#pragma once

#include <vector>

#include "base/grid.hpp"

namespace rouleau::testing {

inline Block whole(const Lattice& lattice) { return {{0, 0, 0}, lattice.size}; }

/// parts[0] x parts[1] x parts[2] blocks of unequal sizes.
inline std::vector<Block> cut(const Lattice& lattice, const Int3& parts) {
  const auto border = [&](int axis, int part) {
    const int n = lattice.size[axis];
    // One node off the even cut, so that no two blocks are alike.
    return part == 0 ? 0 : part == parts[axis] ? n : n * part / parts[axis] + 1;
  };
  std::vector<Block> blocks;
  for (int c = 0; c < parts[2]; ++c)
    for (int b = 0; b < parts[1]; ++b)
      for (int a = 0; a < parts[0]; ++a) {
        const Int3 begin{border(0, a), border(1, b), border(2, c)};
        const Int3 end{border(0, a + 1), border(1, b + 1), border(2, c + 1)};
        blocks.push_back({begin, {end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]}});
      }
  return blocks;
}

/// The cuts that every test of independence walks through: each axis, and all at once.
inline std::vector<Int3> cuts() { return {{2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {3, 2, 2}}; }

/// Calls visit(i, j, k) for the owned nodes of a block, in local coordinates, and `halo` nodes around.
template <class Visit>
void for_each_node(const Block& block, int halo, Visit visit) {
  for (int k = -halo; k < block.size[2] + halo; ++k)
    for (int j = -halo; j < block.size[1] + halo; ++j)
      for (int i = -halo; i < block.size[0] + halo; ++i) visit(i, j, k);
}

/// Fills a block's field, halo included, from value(global node); `poison` stands beyond walls.
template <class T, class Value>
void fill(Field<T>& field, const Lattice& lattice, const Block& block, T poison, Value value) {
  for_each_node(block, field.layout.halo, [&](int i, int j, int k) {
    Int3 node{block.begin[0] + i, block.begin[1] + j, block.begin[2] + k};
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis) {
      node[axis] = lattice.wrap(axis, node[axis]);
      exists = exists && lattice.contains(axis, node[axis]);
    }
    field(i, j, k) = exists ? value(node) : poison;
  });
}

}  // namespace rouleau::testing
