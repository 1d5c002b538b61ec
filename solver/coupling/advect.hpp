// SPDX-License-Identifier: BSD-3-Clause
// Advection: the vertices move with the fluid.
#pragma once

#include <cstdint>
#include <span>

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

enum class Advection {
  euler,           ///< X += U
  adams_bashforth  ///< X += 3/2 U - 1/2 U_previous: second order
};

/// Moves vertices by one time step (dt = 1).
/// reads  cells.U, and for Adams-Bashforth cells.U_previous        [vertices]
/// adds to cells.X                                                 lattice units
/// sets   cells.U_previous = cells.U for Adams-Bashforth
/// throws Error(physics) naming vertex, cell and position if a vertex is not finite or has gone through a wall
///
/// `vertices` are those to move, in any order. A rank that holds U of all vertices moves all of them, so that X and
/// U_previous stay alike everywhere without a further exchange.
void advect(Cells& cells, std::span<const std::int32_t> vertices, Advection scheme, const Lattice& lattice);
/// The same for all vertices.
void advect(Cells& cells, Advection scheme, const Lattice& lattice);

/// Makes the first Adams-Bashforth step of a run an Euler step: U_previous = U. Call it at step 0, after interpolating;
/// a resumed run has its U_previous from the checkpoint.
void start_history(Cells& cells);

}  // namespace rouleau
