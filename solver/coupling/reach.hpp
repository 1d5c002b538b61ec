// SPDX-License-Identifier: BSD-3-Clause
// Which nodes along x any stencil reaches: only there must the velocity be known beyond a block.
#pragma once

#include <span>
#include <vector>

#include "coupling/stencils.hpp"

namespace rouleau {

/// Made once; nothing is allocated afterwards.
class ReachAlongX {
 public:
  /// `halo`: velocity nodes beyond the block.
  ReachAlongX(const Lattice& lattice, const Block& block, int halo);

  /// Sets the runs for the present stencils of all vertices, whoever owns them: the same on all ranks that share their
  /// x. reads  stencils.first[0]
  void find(const Stencils& stencils);

  /// Ascending; from -halo to size + halo, so that a seam counts at both of its ends.
  [[nodiscard]] std::span<const Run> runs() const { return runs_; }
  /// Whether a run begins or ends in the halo.
  [[nodiscard]] bool reaches_halo() const;

 private:
  Lattice lattice_;
  Block block_;
  int halo_;
  std::vector<std::uint8_t> is_first_;    ///< [nodes along x] a stencil begins here, or beyond the wall next to here
  std::vector<std::uint8_t> is_reached_;  ///< [nodes along x]
  std::vector<Run> runs_;
};

}  // namespace rouleau
