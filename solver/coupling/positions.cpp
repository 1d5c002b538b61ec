// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/positions.hpp"

#include <array>
#include <cmath>

#include "base/error.hpp"

namespace rouleau {
namespace {

int cell_of(const Cells& cells, std::size_t vertex) {
  for (std::size_t c = 0; c < cells.ranges.size(); ++c)
    if (vertex < static_cast<std::size_t>(cells.ranges[c].vertex_end)) return static_cast<int>(c);
  return -1;
}

}  // namespace

void check_positions(const Cells& cells, const Lattice& lattice) {
  const std::array<PositionRange, 3> range{PositionRange(lattice, 0), PositionRange(lattice, 1),
                                           PositionRange(lattice, 2)};
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const Vec3 X = at(cells.X, v);
    for (int axis = 0; axis < 3; ++axis) {
      if (range[axis].contains(X[axis])) continue;
      if (!std::isfinite(X[axis]) || lattice.periodic[axis])
        fail(Exit::physics,
             "the position of vertex {} of cell {} is ({:.6g}, {:.6g}, {:.6g}) node spacings: not a place on the "
             "lattice. "
             "Try a smaller time step.",
             v, cell_of(cells, v), X[0], X[1], X[2]);
      const bool is_low = X[axis] < range[axis].low;
      fail(Exit::physics,
           "vertex {} of cell {} has gone through the {} {} wall: it is at ({:.6g}, {:.6g}, {:.6g}) node spacings, the "
           "wall at {:.6g}. Try a smaller time step.",
           v, cell_of(cells, v), is_low ? "low" : "high", "xyz"[axis], X[0], X[1], X[2],
           is_low ? range[axis].low : range[axis].high);
    }
  }
}

}  // namespace rouleau
