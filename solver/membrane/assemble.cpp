// SPDX-License-Identifier: BSD-3-Clause
// From single surfaces to the cells of a run: concatenation, adjacency, reference volumes and areas.
#include "membrane/assemble.hpp"

#include "base/error.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

bool have_equal_triangles(const Surface& one, const Surface& other) {
  return one.X.size() == other.X.size() && one.triangles.a == other.triangles.a &&
         one.triangles.b == other.triangles.b && one.triangles.c == other.triangles.c;
}

void append(Array<double>& to, const Array<double>& from) { to.insert(to.end(), from.begin(), from.end()); }

void append(VectorArray& to, const VectorArray& from) {
  append(to.x, from.x);
  append(to.y, from.y);
  append(to.z, from.z);
}

void append(Array<std::int32_t>& to, const Array<std::int32_t>& from, std::int32_t first_vertex) {
  for (const std::int32_t v : from) to.push_back(first_vertex + v);
}

}  // namespace

Cells assemble(std::span<const CellStart> starts) {
  Cells cells;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Surface& shape = starts[i].shape;
    const Surface& reference = starts[i].reference ? *starts[i].reference : shape;
    if (!have_equal_triangles(shape, reference)) {
      fail(Exit::bad_input,
           "cell {}: the reference shape ({} vertices, {} triangles) has other triangles than the initial shape ({}, "
           "{}). "
           "Take both from one mesh.",
           i, reference.X.size(), reference.triangles.size(), shape.X.size(), shape.triangles.size());
    }
    CellRange range;
    range.vertex_begin = static_cast<std::int32_t>(cells.X.size());
    range.triangle_begin = static_cast<std::int32_t>(cells.triangles.size());
    append(cells.X, shape.X);
    append(cells.X_reference, reference.X);
    append(cells.triangles.a, shape.triangles.a, range.vertex_begin);
    append(cells.triangles.b, shape.triangles.b, range.vertex_begin);
    append(cells.triangles.c, shape.triangles.c, range.vertex_begin);
    range.vertex_end = static_cast<std::int32_t>(cells.X.size());
    range.triangle_end = static_cast<std::int32_t>(cells.triangles.size());
    range.volume_0 = volume(reference);
    range.area_0 = area(reference);
    cells.ranges.push_back(range);
  }
  cells.U.resize(cells.X.size());
  cells.U_previous.resize(cells.X.size());
  cells.F.resize(cells.X.size());
  cells.images.assign(starts.size(), Int3{});
  cells.around = triangles_around(cells.triangles, cells.X.size());
  return cells;
}

VertexTriangles triangles_around(const Triangles& triangles, std::size_t vertices) {
  VertexTriangles around;
  around.begin.assign(vertices + 1, 0);
  const Array<std::int32_t>* corners[3] = {&triangles.a, &triangles.b, &triangles.c};
  for (const auto* corner : corners) {
    for (const std::int32_t v : *corner) ++around.begin[v + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v) around.begin[v + 1] += around.begin[v];
  around.triangle.resize(3 * triangles.size());
  around.corner.resize(3 * triangles.size());
  Array<std::int32_t> next(around.begin.begin(), around.begin.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t entry = next[(*corners[k])[t]]++;
      around.triangle[entry] = static_cast<std::int32_t>(t);
      around.corner[entry] = k;
    }
  }
  return around;
}

}  // namespace rouleau
