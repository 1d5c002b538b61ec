// SPDX-License-Identifier: BSD-3-Clause
// What the delta kernel hides from the mesh: the motion that forces of the shortest waves on it cause.
//
// Spreading and interpolating multiply the response of the fluid to a wave of forces by the square of the kernel's
// Fourier transform. For the shortest wave a mesh of 0.8 node spacings can carry this is about 1e-3 (4-point kernel):
// such waves hardly relax, while the error of interpolation goes on feeding them, until triangles collapse and fold
// (studies/safe-combinations). The vertices therefore get part of the hidden response back,
//
//   U_v += m sum over neighbours w of (F_v - F_w),   m = mobility / (16 pi (mu_out + mu_in) a),
//
// a the mean edge at rest. On a sheet in Stokes flow the shortest wave of a hexagonal mesh, q = 2 pi / (sqrt(3) a), of
// which the sum takes 8 F, answers with U = F / (2 pi (mu_out + mu_in) a): `mobility` is the share of this that is
// added. Against the resolved response the term falls as (q a)^3; it moves no cell as a whole (the terms of one cell
// cancel) and only takes energy (the sum is a positive graph Laplacian).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arrays.hpp"
#include "coupling/stencils.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// Made once for cells whose topology and reference stay as they are. Nothing is allocated after construction.
class MeshMobility {
 public:
  /// `mobility` in [0, 0.3]: stable for every kappa_A dt / (mu dx) that a run may have; `viscosity_sum` mu_out + mu_in,
  /// lattice units.
  MeshMobility(const Cells& cells, double mobility, double viscosity_sum);

  /// The vertices whose forces this block needs: to spread them, and around the vertices it owns.   [vertices] 1:
  /// needed
  [[nodiscard]] std::span<const std::uint8_t> needs(const Stencils& stencils);

  /// reads   cells.F      of the vertices in `owned` and of their neighbours
  /// adds to cells.U      of the vertices in `owned`
  void add(Cells& cells, std::span<const std::int32_t> owned) const;

 private:
  Array<std::int32_t> begin_, neighbour_;  ///< those of v: entries [begin_[v], begin_[v + 1]), around v
  Array<double> m_;                        ///< [vertices] the same for all of a cell
  Array<std::uint8_t> needed_;             ///< [vertices] work space
};

}  // namespace rouleau
