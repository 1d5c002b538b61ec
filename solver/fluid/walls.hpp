// SPDX-License-Identifier: BSD-3-Clause
// Half-way bounce-back walls, standing or moving, by filling the nodes beyond them: the row loop knows nothing of
// walls.
#pragma once

#include "fluid/fluid.hpp"

namespace rouleau {

/// For every node h beyond a wall and every q for which n = h + c_q is an owned node:
///   f_q(h) = f_opposite(q)(n) + 6 w_q rho_0 c_q . u_wall,  rho_0 = 1        [Ladd1994]
/// With rho_0 = 1, not the local density, what a wall moving in its plane adds at a node sums to zero: mass is
/// conserved. Where a link passes through the edge of two walls it meets the wall of the later axis (z before y before
/// x). reads  fluid.f of owned nodes sets   fluid.f beyond the walls that the block touches, over the halo of the other
/// axes too: call it after those are filled
template <class Real>
void fill_walls(Fluid<Real>& fluid);

/// throws Error(bad_input) if a wall moves out of its plane, moves on a periodic axis, or is faster than Mach 0.3
void require_wall_velocities(const Lattice& lattice, const std::array<std::array<Vec3, 2>, 3>& wall_velocity);

/// On one rank that owns the whole lattice: all halos of fluid.f that a step reads, periodic ones first, then walls.
template <class Real>
void fill_halos(Fluid<Real>& fluid);

extern template void fill_walls(Fluid<float>&);
extern template void fill_walls(Fluid<double>&);
extern template void fill_halos(Fluid<float>&);
extern template void fill_halos(Fluid<double>&);

}  // namespace rouleau
