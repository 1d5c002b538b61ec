// SPDX-License-Identifier: BSD-3-Clause
// Sums of triangle values over the triangles around each vertex, eight vertices at a time.
#include "membrane/vertex_gather.hpp"

#include <algorithm>

namespace rouleau {

VertexGather::VertexGather(const VertexTriangles& around, std::int32_t corner_stride, std::int32_t zero_slot) {
  const auto vertices = static_cast<std::int32_t>(around.begin.size()) - 1;
  begin_.push_back(0);
  for (std::int32_t first = 0; first < vertices; first += width) {
    const std::int32_t last = std::min(first + width, vertices);
    std::int32_t rows = 0;
    for (std::int32_t v = first; v < last; ++v) rows = std::max(rows, around.begin[v + 1] - around.begin[v]);
    for (std::int32_t row = 0; row < rows; ++row) {
      for (std::int32_t v = first; v < first + width; ++v) {
        const bool has_triangle = v < last && around.begin[v] + row < around.begin[v + 1];
        const std::int32_t entry = has_triangle ? around.begin[v] + row : 0;
        slots_.push_back(has_triangle ? around.corner[entry] * corner_stride + around.triangle[entry] : zero_slot);
      }
    }
    begin_.push_back(begin_.back() + rows);
  }
}

}  // namespace rouleau
