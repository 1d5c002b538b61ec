// SPDX-License-Identifier: BSD-3-Clause
// The nodes that tracking looks at, found slowly.
#pragma once

#include <cmath>

#include "base/grid.hpp"
#include "interior/flags.hpp"
#include "membrane/cells.hpp"

namespace rouleau::testing {

/// Marks each node among the eight around each vertex.
inline Flags shell_of(const Cells& cells, const Lattice& lattice) {
  Flags shell(lattice.size, 1);
  for (std::size_t v = 0; v < cells.vertices(); ++v)
    for (int corner = 0; corner < 8; ++corner) {
      Int3 n;
      bool exists = true;
      for (int axis = 0; axis < 3; ++axis) {
        n[axis] = lattice.wrap(axis, static_cast<int>(std::floor(at(cells.X, v)[axis])) + (corner >> axis & 1));
        exists = exists && lattice.contains(axis, n[axis]);
      }
      if (exists) shell(n[0], n[1], n[2]) = 1;
    }
  return shell;
}

}  // namespace rouleau::testing
