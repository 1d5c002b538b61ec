// SPDX-License-Identifier: BSD-3-Clause
// The edges of a closed mesh, each with its two triangles.
#include "membrane/edges.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "membrane/ordered_sum.hpp"
#include "membrane/v3.hpp"

namespace rouleau {
namespace {

/// One side of an edge: a < b, and whether its triangle runs from a to b.
struct Side {
  std::int32_t a, b;
  bool runs_forward;
  std::int32_t triangle;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<Side> sorted_sides(const Triangles& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::int32_t corner[4] = {triangles.a[t], triangles.b[t], triangles.c[t], triangles.a[t]};
    for (int k = 0; k < 3; ++k) {
      const std::int32_t from = corner[k], to = corner[k + 1];
      sides.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<std::int32_t>(t)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

Edges find_edges(const Triangles& triangles, const std::string& name) {
  const std::vector<Side> sides = sorted_sides(triangles);
  Edges edges;
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && sides[last].a == sides[first].a && sides[last].b == sides[first].b) ++last;
    const Side& side = sides[first];
    if (last - first == 1) {
      fail(Exit::bad_input, "{}: edge {}-{} belongs to triangle {} alone; the surface is not closed. Fill the hole.",
           name, side.a, side.b, side.triangle);
    }
    if (last - first > 2) {
      fail(Exit::bad_input,
           "{}: edge {}-{} belongs to {} triangles ({}, {}, {}{}); two are allowed. Separate the sheets.", name, side.a,
           side.b, last - first, side.triangle, sides[first + 1].triangle, sides[first + 2].triangle,
           last - first > 3 ? ", ..." : "");
    }
    const Side& other = sides[first + 1];
    if (side.runs_forward == other.runs_forward) {
      fail(Exit::bad_input,
           "{}: triangles {} and {} run along edge {}-{} in the same direction; one of them is turned inside out. "
           "Reverse the order of its vertices.",
           name, side.triangle, other.triangle, side.a, side.b);
    }
    edges.a.push_back(side.a);
    edges.b.push_back(side.b);
    edges.left.push_back(other.triangle);  // sorted: backward stands before forward
    edges.right.push_back(side.triangle);
    first = last;
  }
  return edges;
}

EdgeLengths edge_lengths(const Edges& edges, const VectorArray& X) {
  const ConstV3s x(X);
  EdgeLengths lengths;
  if (edges.size() == 0) return lengths;
  const auto length = [&](std::size_t e) {
    const V3 d = x[edges.b[e]] - x[edges.a[e]];
    return std::sqrt(dot(d, d));
  };
  lengths.min = lengths.max = length(0);
  for (std::size_t e = 1; e < edges.size(); ++e) {
    lengths.min = std::min(lengths.min, length(e));
    lengths.max = std::max(lengths.max, length(e));
  }
  const auto count = static_cast<std::ptrdiff_t>(edges.size());
  lengths.mean = ordered_sum(0, count, length) / static_cast<double>(count);
  return lengths;
}

EdgeLengths edge_lengths(const Surface& surface) {
  return edge_lengths(find_edges(surface.triangles, "surface"), surface.X);
}

}  // namespace rouleau
