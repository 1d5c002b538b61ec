// SPDX-License-Identifier: BSD-3-Clause
// Advection: the vertices move with the fluid.
#pragma once

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

enum class Advection {
  euler,            ///< X += U: first order
  adams_bashforth,  ///< X += 3/2 U - 1/2 U_previous: second order
  averaged          ///< X += 1/2 U + 1/2 U_previous: first order, blind to velocities that change sign with each step
};

/// Moves all vertices by one time step (dt = 1): on every rank, so that X and U_previous stay alike everywhere.
/// reads  cells.U, cells.U_previous        [vertices]
/// adds to cells.X                         lattice units
/// sets   cells.U_previous = cells.U
/// throws Error(physics) naming vertex, cell and position if a vertex is not finite or has gone through a wall
void advect(Cells& cells, Advection scheme, const Lattice& lattice);

/// Makes the first step of a scheme with a history an Euler step: U_previous = U. Call it at step 0, after
/// interpolating; a resumed run has its U_previous from the checkpoint.
void start_history(Cells& cells);

}  // namespace rouleau
