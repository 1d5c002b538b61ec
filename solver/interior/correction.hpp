// SPDX-License-Identifier: BSD-3-Clause
// The correction step: removes flags that the update step left behind.                 [paper, section 3.3 and Table 1]
#pragma once

#include <array>
#include <cstdint>

#include "base/grid.hpp"
#include "interior/flags.hpp"

namespace rouleau {

/// A node inside needs at least `fewest_to_stay` inside neighbours; a node outside with `enough_to_join` is taken in.
struct Thresholds {
  int fewest_to_stay;  ///< a of Table 1
  int enough_to_join;  ///< d of Table 1
};

/// Table 1, for a node with `neighbours` existing neighbours: 8 and 18 of 26, in proportion elsewhere, rounded.
constexpr Thresholds thresholds(int neighbours) {
  return {(2 * 8 * neighbours + 26) / (2 * 26), (2 * 18 * neighbours + 26) / (2 * 26)};
}

struct Corrections {
  std::int64_t activated = 0;    ///< nodes taken in: holes
  std::int64_t deactivated = 0;  ///< nodes dropped: tails
};

/// Sees each node with its 26 neighbours at once, all in their state before the correction.
class Correction {
 public:
  /// Allocates for this block; `apply` allocates nothing.
  Correction(const Lattice& lattice, const Block& block);

  /// Corrects the owned nodes and counts what changed on this block.
  /// reads   flags   owned nodes and one halo node, filled by the caller across periodic borders and blocks
  /// sets    flags   owned nodes; the halo is stale afterwards
  /// Neighbours beyond walls do not exist: there the thresholds scale. Departs from the paper in that borders between
  /// processes are no borders, so that the result does not depend on the number of ranks.
  Corrections apply(Flags& flags);

 private:
  void correct_row(const Flags& flags, int j, int k, std::uint8_t* out);
  [[nodiscard]] bool exists(int axis, int local) const {
    return lattice_.periodic[axis] || lattice_.contains(axis, block_.begin[axis] + local);
  }

  Lattice lattice_;
  Block block_;
  Array<std::uint8_t> corrected_;  ///< [z][y][x] of the block: the flags to come
  Array<std::uint8_t> columns_;    ///< [x + 2]: flags of the nine nodes of a row's cross section, added up
};

}  // namespace rouleau
