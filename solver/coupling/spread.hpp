// SPDX-License-Identifier: BSD-3-Clause
// Spreading: the forces of the vertices become a force density on the nodes.
#pragma once

#include "base/grid.hpp"
#include "coupling/stencils.hpp"

namespace rouleau {

/// Adds the membrane forces to the force density of the fluid: g(x) = sum_v F_v delta(x - X_v).   [Peskin2002]
/// reads  F               of the vertices in stencils.spreading           [vertices], lattice units
/// adds to g              owned nodes of the block only                    force per node volume
/// marks  stencils.written_rows
/// A node sums in ascending vertex order, so its value does not depend on how the lattice is cut. Near walls the rule
/// of coupling/walls.hpp holds: the sum over all nodes is the sum over all vertices.
template <class Real>
void spread(const VectorArray& F, Stencils& stencils, VectorField<Real>& g);

/// Zeroes the owned nodes of the rows that `spread` has written since the last call: all of g if nobody else writes
/// there.
template <class Real>
void clear_touched(Stencils& stencils, VectorField<Real>& g);

extern template void spread(const VectorArray&, Stencils&, VectorField<float>&);
extern template void spread(const VectorArray&, Stencils&, VectorField<double>&);
extern template void clear_touched(Stencils&, VectorField<float>&);
extern template void clear_touched(Stencils&, VectorField<double>&);

}  // namespace rouleau
