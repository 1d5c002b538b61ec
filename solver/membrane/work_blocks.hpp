// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of triangles and vertices must be computed so that the forces of the needed vertices come out whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "membrane/cells.hpp"

namespace rouleau {

/// Bending reaches two rings: a vertex's force takes its triangles, these take the curvature of all their corners, and
/// the curvature takes all triangles around those corners. Decided on blocks, from lists made once.
class WorkBlocks {
 public:
  static constexpr int triangles_per_block = 32;
  static constexpr int vertices_per_block = 8;

  explicit WorkBlocks(const Cells& cells);

  /// Sets the four lists below. `needed`: a byte a vertex; empty means all.
  void select(std::span<const std::uint8_t> needed);

  /// Blocks in ascending order, of triangles whose curvature is needed, vertices whose curvature is needed, triangles
  /// whose force is needed, vertices whose force is needed.
  [[nodiscard]] std::span<const std::int32_t> curvature_triangles() const { return curvature_triangles_; }
  [[nodiscard]] std::span<const std::int32_t> curvature_vertices() const { return curvature_vertices_; }
  [[nodiscard]] std::span<const std::int32_t> force_triangles() const { return force_triangles_; }
  [[nodiscard]] std::span<const std::int32_t> force_vertices() const { return force_vertices_; }

 private:
  std::vector<std::int32_t> neighbours_begin_, neighbours_;  ///< vertex blocks that a triangle block touches
  std::vector<std::uint8_t> vertex_mark_;
  std::vector<std::int32_t> curvature_triangles_, curvature_vertices_, force_triangles_, force_vertices_;
};

}  // namespace rouleau
