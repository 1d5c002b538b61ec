// SPDX-License-Identifier: BSD-3-Clause
// What keeps two neighbouring triangles from folding flat onto each other.
//
// The bending energy of a mesh saturates: along an edge it grows as sin^2(theta/2) with the angle theta between the two
// normals, so that its torque falls again beyond 90 degrees. A rim narrower than an edge, such as the skirt of a
// croissant, then closes like a book, which the smooth membrane, whose energy grows without bound, never does
// (studies/safe-combinations). With c = cos theta, every edge sharper than 60 degrees therefore gets the energy
//
//   E_e = k kappa_B (c_0 - c)^2 / (1 + c)    where c < c_0 = 1/2,    else 0,
//
// infinite where the fold closes and smooth where it sets in. On a resolved surface, whose angles vanish with the
// length of its edges, it is exactly nothing.
#pragma once

#include <vector>

#include "membrane/cells.hpp"
#include "membrane/edges.hpp"
#include "membrane/packed.hpp"

namespace rouleau {

/// Made once for cells whose topology stays as it is. Nothing is allocated after construction.
class FoldResistance {
 public:
  /// `k_kappa_B` k kappa_B, lattice units.
  FoldResistance(const Cells& cells, double k_kappa_B);

  /// reads   cells.X
  /// adds to cells.F   of all vertices, minus the gradient of `energy`, edge after edge
  void add(Cells& cells);

  /// Sum over all edges, added up in a fixed order.
  [[nodiscard]] double energy(const Cells& cells);

 private:
  void find_normals(const Cells& cells);

  double k_kappa_B_;
  Edges edges_;
  Array<std::int32_t> left_corner_, right_corner_;  ///< [edges] the vertex facing the edge
  Array<Packed> X_;                                 ///< [vertices] positions
  Array<Packed> N_;                                 ///< [triangles] twice the area vector, and its square in w
};

}  // namespace rouleau
