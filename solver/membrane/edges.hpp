// SPDX-License-Identifier: BSD-3-Clause
// The edges of a closed mesh, each with its two triangles.
#pragma once

#include <string>

#include "membrane/cells.hpp"

namespace rouleau {

/// Edge e runs from vertex a[e] to b[e], a < b; triangle left[e] has it in this direction, right[e] the other way.
struct Edges {
  Array<std::int32_t> a, b, left, right;
  [[nodiscard]] std::size_t size() const { return a.size(); }
};

/// Edges in ascending order of (a, b).
/// throws  Error (bad_input) naming `name` and the edge, if an edge has not exactly one triangle a direction
Edges find_edges(const Triangles& triangles, const std::string& name);

struct EdgeLengths {
  double min = 0, mean = 0, max = 0;
};

/// Lengths in the unit of `X`.
EdgeLengths edge_lengths(const Edges& edges, const VectorArray& X);
/// Lengths of a surface that check_surface accepts.
EdgeLengths edge_lengths(const Surface& surface);

}  // namespace rouleau
