// SPDX-License-Identifier: BSD-3-Clause
// What a surface must fulfil to enclose a cell.
#pragma once

#include <string>

#include "membrane/cells.hpp"

namespace rouleau {

/// Accepts one closed, connected, consistently oriented manifold with outward normals, finite coordinates, no
/// degenerate triangle, no duplicate and no unreferenced vertex. Self-intersections are not searched.
/// throws  Error (bad_input) naming `name` and the triangle, vertex or edge (numbered from 0 as in the file)
void check_surface(const Surface& surface, const std::string& name);

}  // namespace rouleau
