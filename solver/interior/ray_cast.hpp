// SPDX-License-Identifier: BSD-3-Clause
// Inside or outside by ray casting: a node is inside a cell if a ray from it crosses the membrane an odd number of
// times.
#pragma once

#include "base/grid.hpp"
#include "interior/flags.hpp"
#include "membrane/cells.hpp"

namespace rouleau {

/// How the triangles that a ray may meet are found. Both give the same flags, bit for bit.
enum class RaySearch {
  direct,  ///< the paper's form: each node against each triangle of a cell
  columns  ///< triangles sorted into columns along the ray: each node against the few of its column
};

/// Flags the nodes inside any of the cells.
/// reads  cells.X, cells.triangles   a cell may straddle periodic borders and lie anywhere in periodic space
/// sets   flags                      all owned nodes
/// Several cells are united (never differenced), and so are the periodic images of one.
void cast_rays(const Cells& cells, const Lattice& lattice, const Block& block, RaySearch search, Flags& flags);

/// The same for the nodes next to the membrane alone, the eight around each vertex: what the paper compares its
/// tracking with (time ~ N^4 if direct). sets   flags                      owned nodes next to a vertex; all others
/// stay
void cast_rays_near_membrane(const Cells& cells, const Lattice& lattice, const Block& block, RaySearch search,
                             Flags& flags);

}  // namespace rouleau
