// SPDX-License-Identifier: BSD-3-Clause
// What flags by ray casting cost, where the full cast may take minutes.
#pragma once

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau::speed {

/// Seconds to cast a ray from each node against each triangle: the paper's slowest method. Only from the nodes of
/// `planes` planes spread evenly over z, and scaled to all: each node costs the same, wherever it lies.
double full_cast_seconds(const Cells& cells, const Lattice& lattice, int planes);

/// Seconds to cast all rays against the triangles of their column only: this code's method, not the paper's.
double column_cast_seconds(const Cells& cells, const Lattice& lattice, double enough_s);

/// Seconds to cast a ray from each node next to the membrane against each triangle.
double shell_cast_seconds(const Cells& cells, const Lattice& lattice, double enough_s);

}  // namespace rouleau::speed
