// SPDX-License-Identifier: BSD-3-Clause
// Volume and area of a cell, and the shift of its vertices that restores the volume.
#pragma once

#include "membrane/cells.hpp"
#include "membrane/packed.hpp"

namespace rouleau {

/// Enclosed volume by the divergence theorem, summed in a fixed order; negative if the normals point inwards.
double volume(const Triangles& triangles, const VectorArray& X, const CellRange& range);
double volume(const Cells& cells, std::size_t cell);
double volume(const Surface& surface);

/// Area of all triangles, summed in a fixed order.
double area(const Triangles& triangles, const VectorArray& X, const CellRange& range);
double area(const Cells& cells, std::size_t cell);
double area(const Surface& surface);

/// Restores each cell's volume; holds the workspace, made once for a set of cells.
class VolumeShift {
 public:
  explicit VolumeShift(const Cells& cells);

  /// Shifts X along dV/dX by the one multiplier m that restores volume_0: the root near 0 of the cubic
  /// V(X + m dV/dX) = V0. |V/V0 - 1| < 1e-12 afterwards. No allocation.
  /// reads and sets  cells.X
  /// returns the largest |V/V0 - 1| found before the shift
  /// throws  Error (physics) if a volume is not finite, off by more than largest_volume_error, or cannot be restored
  double restore(Cells& cells);

  static constexpr double largest_volume_error = 0.1;

 private:
  double restore_cell(Cells& cells, std::size_t cell);
  void sum_gradients(const Cells& cells, const CellRange& range);

  Array<Packed> X_;         ///< [vertices] relative to the cell's first vertex
  Array<Packed> gradient_;  ///< [vertices] 6 dV/dX
};

}  // namespace rouleau
