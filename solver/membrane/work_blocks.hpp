// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of triangles and vertices must be computed so that the forces of the needed vertices come out whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "membrane/cells.hpp"

namespace rouleau {

/// Bending reaches two rings: a vertex's force takes its triangles, these take the curvature of all their corners, and
/// the curvature takes all triangles around those corners. Whole blocks are computed, from lists made once.
class WorkBlocks {
 public:
  static constexpr int size = 32;  ///< of a block of triangles and of a block of vertices

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
  void list_marked_vertices(std::vector<std::int32_t>& blocks) const;
  void list_triangles_at_marks(std::vector<std::int32_t>& blocks) const;

  std::vector<std::int32_t> corners_begin_, corners_;  ///< vertices that a triangle block touches, each once
  std::vector<std::uint8_t> mark_;                     ///< a byte a vertex
  std::vector<std::int32_t> curvature_triangles_, curvature_vertices_, force_triangles_, force_vertices_;
};

}  // namespace rouleau
