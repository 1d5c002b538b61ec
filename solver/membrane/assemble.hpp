// SPDX-License-Identifier: BSD-3-Clause
// From single surfaces to the cells of a run: concatenation, adjacency, reference volumes and areas.
#pragma once

#include <optional>
#include <span>

#include "membrane/cells.hpp"

namespace rouleau {

/// One cell to be: where it starts, and its stress-free shape if that is another one (same triangles, same scale).
struct CellStart {
  Surface shape;
  std::optional<Surface> reference;
};

/// Concatenates the cells. V0 and A0 are those of the reference where it is given, else of the shape: a run started
/// from a deformed cell returns to the volume of the stress-free cell, not to that of the moment it was saved.
/// Positions as given; U, U_previous, F and images are zero.
/// throws  Error (bad_input) if a reference has other triangles than its shape
Cells assemble(std::span<const CellStart> starts);

/// For each vertex its triangles in ascending order.
VertexTriangles triangles_around(const Triangles& triangles, std::size_t vertices);

}  // namespace rouleau
