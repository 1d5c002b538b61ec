// SPDX-License-Identifier: BSD-3-Clause
// The elastic forces of all membranes: Skalak in the plane, Helfrich out of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "membrane/cells.hpp"
#include "membrane/vertex_gather.hpp"
#include "membrane/work_blocks.hpp"

namespace rouleau {

/// Energies in lattice units, of all cells together.
struct MembraneEnergy {
  double skalak = 0;
  double bending = 0;
};

/// Holds the reference metrics and the workspace. Made once for cells whose topology and reference stay as they are.
class MembraneForces {
 public:
  /// throws  Error (bad_input) if a reference triangle has no area
  explicit MembraneForces(const Cells& cells);

  /// Membrane forces on the fluid, minus the gradient of `energy`.   [Lehmann2020] Eqs. 7-13
  /// reads   cells.X of all vertices
  /// sets    cells.F[v] wherever needed[v] is not 0 (empty mask: everywhere); other F are unspecified
  /// The bits of F[v] do not depend on the mask. No allocation.
  void compute(Cells& cells, const Moduli& moduli, std::span<const std::uint8_t> needed = {});

  /// Energies at cells.X, summed in a fixed order. No allocation.
  MembraneEnergy energy(const Cells& cells, const Moduli& moduli);

 private:
  struct ReferenceMetrics {
    Array<double> G11, G12, G22, inverse_det, area;
  };
  /// One value a corner: [3][corner_stride], then a zero.
  using CornerArray = Array<double>;

  void stretch(const Cells& cells, const Moduli& moduli, std::int32_t begin, std::int32_t end);
  void weigh_corners(const Cells& cells, std::int32_t begin, std::int32_t end);
  void sum_curvature(std::int32_t vertex_block);
  void add_bending(const Cells& cells, double kappa_B, std::int32_t begin, std::int32_t end);
  void sum_forces(Cells& cells, std::int32_t vertex_block) const;
  [[nodiscard]] std::int32_t block_end(std::int32_t triangle_block) const;

  std::int32_t triangles_ = 0, corner_stride_ = 0;
  ReferenceMetrics reference_;
  VertexGather gather_;
  WorkBlocks work_;
  std::array<CornerArray, 3> force_;      ///< Skalak, then with bending
  std::array<CornerArray, 3> laplacian_;  ///< L of each corner
  CornerArray area_;                      ///< A of each corner
  VectorArray p_;                         ///< [vertices, padded] L / A
  Array<double> s_;                       ///< p.p
};

}  // namespace rouleau
