// SPDX-License-Identifier: BSD-3-Clause
// Interpolation: the velocity of the fluid at the vertices.
#pragma once

#include "base/grid.hpp"
#include "coupling/stencils.hpp"
#include "coupling/walls.hpp"

namespace rouleau {

/// Sums the fluid's velocity over the stencil of each owned vertex: U_v = sum_x u(x) delta(x - X_v).   [Peskin2002]
/// reads  u               owned nodes and two halo nodes, filled by the caller; nothing beyond a wall counts
/// sets   U               of the vertices in stencils.owned                [vertices], lattice units
/// The sum runs over z, y, x in this order, in double: it does not depend on how the lattice is cut. Near walls the
/// rule of coupling/walls.hpp holds.
template <class Real>
void interpolate(const VectorField<Real>& u, const WallVelocities& walls, const Stencils& stencils, VectorArray& U);

extern template void interpolate(const VectorField<float>&, const WallVelocities&, const Stencils&, VectorArray&);
extern template void interpolate(const VectorField<double>&, const WallVelocities&, const Stencils&, VectorArray&);

}  // namespace rouleau
