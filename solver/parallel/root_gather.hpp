// SPDX-License-Identifier: BSD-3-Clause
// Bringing a lattice that is cut into blocks together on rank 0: for pictures, which one process writes.
#pragma once

#include <cstddef>
#include <vector>

#include "base/grid.hpp"
#include "parallel/communicator.hpp"

namespace rouleau {

class RootGather {
 public:
  /// `own` is this rank's block, which may be empty; the blocks of all ranks partition the lattice. Collective.
  RootGather(const Communicator& comm, const Lattice& lattice, const Block& own);

  /// Collective.
  /// reads    packed   [z][y][x][components] of the own block, without gaps
  /// returns  [z][y][x][components] of the whole lattice on rank 0, nothing elsewhere
  template <class T>
  [[nodiscard]] std::vector<T> gather(const std::vector<T>& packed, std::size_t components) const {
    std::vector<T> whole(comm_.is_root() ? static_cast<std::size_t>(lattice_.nodes()) * components : 0);
    gather_bytes(packed.data(), components * sizeof(T), whole.data());
    return whole;
  }

 private:
  void gather_bytes(const void* packed, std::size_t node_bytes, void* whole) const;

  const Communicator& comm_;
  Lattice lattice_;
  std::vector<Block> blocks_;  ///< of every rank
};

}  // namespace rouleau
