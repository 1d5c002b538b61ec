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
  /// [axis][vertices][width] weights before the wall rule.
  std::array<Array<double>, 3> weight;

  Array<std::uint8_t> spreads_here;     ///< [vertices] 1: the stencil touches a node of this block
  Array<std::uint8_t> owned_here;       ///< [vertices] 1: the nearest node is here; exactly one block owns a vertex
  std::vector<std::int32_t> spreading;  ///< the vertices with spreads_here, ascending
  std::vector<std::int32_t> owned;      ///< the vertices with owned_here, ascending; all of them are in `spreading`

  /// [z][y] not 0: a stencil touches the row (j, k) of this block. It will receive force, and its velocity will be read
  /// (by this block or another one): both sets are the same, because mirror nodes lie within the stencil that is
  /// reflected. Bit s says that it does so in the segment s, the nodes [s, s + 1) << segment_shift.
  Array<std::uint8_t> rows;
  /// [z][y] what of each row, in bits as above, `spread` has written since `clear_touched` last zeroed it.
  Array<std::uint8_t> written_rows;
  /// [z][y] the same bits of the stencils that are owned as a whole, where they start only: work space.
  Array<std::uint8_t> starts;
  int segment_shift = 4;  ///< a row has at most eight segments, of one or more cache lines of floats

  /// throws Error(bad_input) if the lattice has fewer nodes along an axis than the kernel needs, or a block at a wall
  /// fewer than the velocity halo of two nodes can serve
  Stencils(Kernel kernel, const Lattice& lattice, const Block& block, std::size_t vertices);

  [[nodiscard]] std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(j) + static_cast<std::size_t>(k) * static_cast<std::size_t>(block.size[1]);
  }
  /// First node of a vertex's stencil in local coordinates; along periodic axes the image that starts on the lattice.
  [[nodiscard]] Int3 local_first(std::size_t v) const {
    return {first[0][v] - block.begin[0], first[1][v] - block.begin[1], first[2][v] - block.begin[2]};
  }
  /// Whether the stencil that starts there is owned as a whole: no wall, no seam and no other block cuts it. Most are,
  /// and take a short path.
  [[nodiscard]] bool is_whole(const Int3& local) const {
    return is_whole(0, local[0]) && is_whole(1, local[1]) && is_whole(2, local[2]);
  }
  [[nodiscard]] bool is_whole(int axis, int local) const { return local >= 0 && local <= block.size[axis] - width; }
  /// Local coordinate of a stencil's node, given as `first` + 0, 1, ...; -1 if this block does not own it.
  [[nodiscard]] int owned_or_none(int axis, int node) const {
    if (lattice.periodic[axis] && node >= lattice.size[axis]) node -= lattice.size[axis];
    const int local = node - block.begin[axis];
    return local >= 0 && local < block.size[axis] ? local : -1;
  }
  [[nodiscard]] const double* weights(int axis, std::size_t v) const {
    return weight[axis].data() + v * static_cast<std::size_t>(width);
  }
};

/// Finds the stencils of all vertices for the present positions.
/// reads  cells.X            [vertices], may lie any number of periods outside the box along periodic axes
/// sets   all of `stencils` but written_rows
/// throws Error(physics) naming cell and vertex if a position is not finite or lies beyond a wall
void find_stencils(const Cells& cells, Stencils& stencils);

}  // namespace rouleau
