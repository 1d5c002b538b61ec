// SPDX-License-Identifier: BSD-3-Clause
// The elastic forces of all membranes: Skalak or neo-Hookean in the plane, Helfrich out of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "membrane/cells.hpp"
#include "membrane/packed.hpp"
#include "membrane/work_blocks.hpp"

namespace rouleau {

/// Energies in lattice units, of all cells together.
struct MembraneEnergy {
  double in_plane = 0;
  double bending = 0;
};

/// Holds the reference metrics and the workspace. Made once for cells whose topology and reference stay as they are.
class MembraneForces {
 public:
  /// throws  Error (bad_input) if a reference triangle has no area
  explicit MembraneForces(const Cells& cells);

  /// Membrane forces on the fluid, minus the gradient of `energy`, by the law that `moduli` names.   [Lehmann2020]
  /// Eqs. 7-13
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

  void pack_positions(const Cells& cells);
  void add_curvatures(std::int32_t triangle_block);
  void divide_by_areas(std::int32_t vertex_block, double kappa_B);
  template <class Law>
  void add_forces(std::int32_t triangle_block, const Law& law);
  template <class Law>
  double in_plane_energy(const Cells& cells, const Law& law) const;
  void unpack_forces(Cells& cells, std::int32_t vertex_block) const;

  WorkBlocks work_;
  // Triangles and vertices are filled up to whole blocks: with triangles of three vertices that no cell has.
  std::int32_t triangles_ = 0;
  std::array<Array<std::int32_t>, 3> corner_;  ///< [triangles, padded]
  ReferenceMetrics reference_;                 ///< [triangles, padded]
  Array<Packed> X_;                            ///< [vertices, padded] positions
  Array<Packed> curvature_;                    ///< [vertices, padded] L and A, then P and S
  Array<Packed> F_;                            ///< [vertices, padded]
};

}  // namespace rouleau
