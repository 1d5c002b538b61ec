// SPDX-License-Identifier: BSD-3-Clause
// How the lattice is cut into one block a rank.
#pragma once

#include "base/grid.hpp"
#include "parallel/communicator.hpp"

namespace rouleau {

/// A Cartesian cut of the lattice: ranks[0] x ranks[1] x ranks[2] blocks, x fastest.
class Decomposition {
 public:
  /// Smallest block along an axis that is cut: the velocity halo of two nodes must come from one neighbour.
  static constexpr int smallest_block = 4;

  /// `ranks` all zero: the cut with the least interface, x last (long rows vectorise, and a cell near the channel's
  /// axis is shared evenly by cuts in y and z). Throws Error(bad_input) if no cut, or not the given one, leaves blocks
  /// of 4 nodes.
  Decomposition(const Lattice& lattice, const Communicator& comm, Int3 ranks = {0, 0, 0});

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] const Int3& ranks() const { return ranks_; }
  [[nodiscard]] const Block& block() const { return block_; }
  /// Rank on the low (side 0) or high (side 1) side along an axis; -1 beyond a wall; the own rank where the axis is not
  /// cut.
  [[nodiscard]] int neighbour(int axis, int side) const;

 private:
  Lattice lattice_;
  Int3 ranks_{};
  Int3 position_{};
  Block block_;
};

/// The cut that `Decomposition` takes if none is given; {0, 0, 0} if there is none.
Int3 choose_ranks(const Lattice& lattice, int ranks);

}  // namespace rouleau
