// SPDX-License-Identifier: BSD-3-Clause
// Bringing cells that left through a periodic face back by one period.
#pragma once

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// Moves each cell whose mean vertex left [-0.5, N - 0.5) along a periodic axis back by whole periods and counts them
/// in `images`, so that X + images * period runs on. A cell is moved whole.
/// reads and sets  cells.X, cells.images
void wrap_cells(Cells& cells, const Lattice& lattice);

}  // namespace rouleau
