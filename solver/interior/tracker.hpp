// SPDX-License-Identifier: BSD-3-Clause
// The update step: follows the membrane by looking only at the nodes next to it.                    [paper,
// section 3.2]
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.hpp"
#include "interior/flags.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// The variants of the paper.
enum class Tracking {
  vertex_normals,       ///< 8 nodes around each vertex, area-weighted vertex normals (r_shell = 1): the paper's choice
  vertex_normals_wide,  ///< 64 nodes (r_shell = 2): for meshes coarse against the lattice
  face_normals          ///< 8 nodes around each triangle's centre, the triangle's own normal
};

/// Decides, for each node near the membrane, by the side of the closest vertex's tangent plane it lies on.
class Tracker {
 public:
  /// Allocates for this block and these cells; `update` allocates nothing.
  Tracker(Tracking variant, const Lattice& lattice, const Block& block, const Cells& cells);

  /// Updates the flags of the owned nodes near the membrane; nodes beyond walls do not exist.
  /// reads   cells.X, cells.triangles, cells.around
  /// sets    flags                      owned nodes in the shell
  /// returns the number of flags that changed on this block
  /// throws  Error(physics) if a position is not finite or no place on a lattice
  /// A node in the shell of several vertices obeys the closest, the lowest index if equally close. It looks at all
  /// vertices near it, whoever owns them, so its flag does not depend on how the lattice is cut.
  std::int64_t update(const Cells& cells, Flags& flags);

 private:
  /// Sets shell_ and closest_; returns the number of nodes in shell_.
  template <int radius, class PointOf, class NormalOf>
  std::size_t collect(std::size_t points, PointOf point_of, NormalOf normal_of);
  /// Sets the flags, and closest_ back; returns the number of flags that changed.
  std::int64_t settle(std::size_t shell_nodes, Flags& flags);

  Tracking variant_;
  Lattice lattice_;
  Block block_;
  Layout layout_;  ///< of the flags, and of closest_
  /// (C) and (D) of the paper in one: a node's squared distance to the closest vertex so far, negative if that vertex
  /// says `inside`. Infinite between updates.
  std::vector<double> closest_;
  std::vector<std::int64_t> shell_;  ///< (B) of the paper: indices of the nodes with an entry in closest_, each once
  /// [2 for each entry of cells.around] the two other corners of the triangle, in its own turn: empty for face normals
  std::vector<std::int32_t> opposite_;
  Array<double> packed_X_;  ///< [vertices][4] positions and a zero: workspace, empty for face normals
};

}  // namespace rouleau
