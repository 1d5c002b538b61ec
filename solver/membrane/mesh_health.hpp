// SPDX-License-Identifier: BSD-3-Clause
// Has a moving mesh lost its meaning? Folded or collapsed triangles, coordinates that are not finite.
#pragma once

#include <optional>
#include <string>

#include "membrane/cells.hpp"
#include "membrane/edges.hpp"

namespace rouleau {

struct MeshLimits {
  /// Two neighbouring triangles count as folded if the cosine between their normals is below this. Ridges as sharp as
  /// 120 degrees pass over the rim of a coarse mesh (1280 triangles) and smooth out again; only a fold flat upon itself
  /// does not.
  double fold_cosine = -0.98;
  /// A triangle counts as collapsed if its area is below this part of its reference area.
  double collapse_area_ratio = 0.02;
};

struct MeshFault {
  std::size_t cell = 0;
  std::size_t triangle = 0;  ///< within the cell; of a vertex fault, the first triangle of the vertex
  std::string what;          ///< one clause for the message: which, the value, the limit
};

/// Made once for a set of cells, whose topology and reference must not change.
class MeshHealth {
 public:
  explicit MeshHealth(const Cells& cells);

  /// The first fault, or nothing. Cells in order; within a cell, coordinates, then collapsed, then folded triangles.
  /// Cost: a few square roots a triangle; allocates only to report a fault.
  [[nodiscard]] std::optional<MeshFault> find_fault(const Cells& cells, const MeshLimits& limits = {});

 private:
  [[nodiscard]] std::optional<MeshFault> find_in_cell(const Cells& cells, std::size_t cell, const MeshLimits& limits);

  Edges edges_;
  std::vector<std::size_t> edge_begin_;  ///< [cells + 1]
  Array<double> reference_area_;         ///< [triangles]
  VectorArray normal_;                   ///< [triangles] of unit length
};

}  // namespace rouleau
