// SPDX-License-Identifier: BSD-3-Clause
// Where each vertex touches the lattice in this step: found once, used to spread forces and to read velocities.
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.hpp"
#include "coupling/delta.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// The stencils of all vertices, and what of them concerns this block. Nothing is allocated after construction.
struct Stencils {
  Kernel kernel;
  int width;
  Lattice lattice;
  Block block;

  /// [axis][vertices] first node of the stencil; in [0, N) along periodic axes, may be beyond a wall.
  std::array<Array<std::int32_t>, 3> first;
  /// [axis][vertices][width] weights before the wall rule; set where spreads_here.
  std::array<Array<double>, 3> weight;

  Array<std::uint8_t> spreads_here;     ///< [vertices] 1: the stencil touches a node of this block
  Array<std::uint8_t> owned_here;       ///< [vertices] 1: the nearest node is here; exactly one block owns a vertex
  std::vector<std::int32_t> spreading;  ///< the vertices with spreads_here, ascending
  std::vector<std::int32_t> owned;      ///< the vertices with owned_here, ascending; all of them are in `spreading`

  /// [z][y] 1: a stencil touches the row (j, k) of this block. It will receive force, and its velocity will be read (by
  /// this block or another one): both sets are the same, because mirror nodes lie within the stencil that is reflected.
  Array<std::uint8_t> rows;
  /// [z][y] 1: `spread` has written the row since `clear_touched` last zeroed it.
  Array<std::uint8_t> written_rows;

  /// throws Error(bad_input) if the lattice has fewer nodes along an axis than the kernel needs, or a block at a wall
  /// fewer than the velocity halo of two nodes can serve
  Stencils(Kernel kernel, const Lattice& lattice, const Block& block, std::size_t vertices);

  [[nodiscard]] std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(j) + static_cast<std::size_t>(k) * static_cast<std::size_t>(block.size[1]);
  }
};

/// Finds the stencils of all vertices for the present positions.
/// reads  cells.X            [vertices], may lie any number of periods outside the box along periodic axes
/// sets   all of `stencils` but written_rows
/// throws Error(physics) naming cell and vertex if a position is not finite or lies beyond a wall
void find_stencils(const Cells& cells, Stencils& stencils);

}  // namespace rouleau
