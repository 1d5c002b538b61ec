// SPDX-License-Identifier: BSD-3-Clause
// Bringing cells that left through a periodic face back by one period.
#include "membrane/wrap.hpp"

#include <array>
#include <cmath>

#include "membrane/measures.hpp"

namespace rouleau {

void wrap_cells(Cells& cells, const Lattice& lattice) {
  const std::array<Array<double>*, 3> X{&cells.X.x, &cells.X.y, &cells.X.z};
  for (std::size_t cell = 0; cell < cells.ranges.size(); ++cell) {
    const CellRange& range = cells.ranges[cell];
    const Vec3 mean = vertex_mean(cells.X, range);
    for (int axis = 0; axis < 3; ++axis) {
      if (!lattice.periodic[axis]) continue;
      const double period = lattice.size[axis];
      const double periods = std::floor((mean[axis] + 0.5) / period);
      if (periods == 0) continue;
      cells.images[cell][axis] += static_cast<int>(periods);
      for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) (*X[axis])[v] -= periods * period;
    }
  }
}

}  // namespace rouleau
