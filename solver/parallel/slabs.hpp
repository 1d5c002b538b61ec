// SPDX-License-Identifier: BSD-3-Clause
// Bringing a lattice that is cut into blocks together as slabs of whole z-planes, one slab a rank.
//
// A slab is one contiguous piece of a global array [z][y][x], so that each rank writes large pieces of a file whatever
// the cut.
#pragma once

#include <cstddef>
#include <vector>

#include "base/grid.hpp"
#include "parallel/communicator.hpp"

namespace rouleau {

class Slabs {
 public:
  /// `own` is this rank's block; the blocks of all ranks partition the lattice. Collective.
  Slabs(const Communicator& comm, const Lattice& lattice, const Block& own);

  [[nodiscard]] int first_plane() const { return first_plane_; }
  [[nodiscard]] int planes() const { return planes_; }  ///< 0 if there are more ranks than planes

  /// Collects this rank's planes of one component. Collective.
  /// reads   packed  [z][y][x] of the own block, without gaps, elements of `element_size` bytes
  /// sets    slab    [planes][y][x] of the whole lattice; resized
  void gather(const std::vector<std::byte>& packed, std::size_t element_size, std::vector<std::byte>& slab);

 private:
  /// The planes that a block and a slab have in common.
  struct Overlap {
    int begin = 0, count = 0;
  };
  [[nodiscard]] int first_plane_of(int rank) const;
  [[nodiscard]] Overlap overlap(const Block& block, int slab_rank) const;
  const Communicator& comm_;
  Lattice lattice_;
  std::vector<Block> blocks_;  ///< of every rank
  int first_plane_ = 0, planes_ = 0;
  std::vector<std::byte> received_;
};

}  // namespace rouleau
