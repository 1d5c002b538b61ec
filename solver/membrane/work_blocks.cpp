// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of triangles and vertices must be computed so that the forces of the needed vertices come out whole.
#include "membrane/work_blocks.hpp"

#include <algorithm>
#include <numeric>

namespace rouleau {

WorkBlocks::WorkBlocks(const Cells& cells) {
  const auto triangles = static_cast<std::int32_t>(cells.triangles.size());
  const auto vertices = static_cast<std::int32_t>(cells.vertices());
  neighbours_begin_.push_back(0);
  for (std::int32_t first = 0; first < triangles; first += triangles_per_block) {
    const std::int32_t last = std::min(first + triangles_per_block, triangles);
    std::vector<std::int32_t> touched;
    for (std::int32_t t = first; t < last; ++t) {
      for (const std::int32_t v : {cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]}) {
        touched.push_back(v / vertices_per_block);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    neighbours_.insert(neighbours_.end(), touched.begin(), touched.end());
    neighbours_begin_.push_back(static_cast<std::int32_t>(neighbours_.size()));
  }
  const std::size_t triangle_blocks = neighbours_begin_.size() - 1;
  const std::size_t vertex_blocks = static_cast<std::size_t>(vertices + vertices_per_block - 1) / vertices_per_block;
  vertex_mark_.resize(vertex_blocks);
  curvature_triangles_.reserve(triangle_blocks);
  force_triangles_.reserve(triangle_blocks);
  curvature_vertices_.reserve(vertex_blocks);
  force_vertices_.reserve(vertex_blocks);
}

namespace {

void list_all(std::vector<std::int32_t>& list, std::size_t count) {
  list.resize(count);
  std::iota(list.begin(), list.end(), 0);
}

}  // namespace

void WorkBlocks::select(std::span<const std::uint8_t> needed) {
  const std::size_t triangle_blocks = neighbours_begin_.size() - 1;
  if (needed.empty()) {
    list_all(curvature_triangles_, triangle_blocks);
    list_all(force_triangles_, triangle_blocks);
    list_all(curvature_vertices_, vertex_mark_.size());
    list_all(force_vertices_, vertex_mark_.size());
    return;
  }
  const auto list_marked_vertices = [&](std::vector<std::int32_t>& list) {
    list.clear();
    for (std::size_t block = 0; block < vertex_mark_.size(); ++block) {
      if (vertex_mark_[block]) list.push_back(static_cast<std::int32_t>(block));
    }
  };
  const auto list_triangles_at_marks = [&](std::vector<std::int32_t>& list) {
    list.clear();
    for (std::size_t block = 0; block < triangle_blocks; ++block) {
      const auto first = neighbours_.begin() + neighbours_begin_[block];
      const auto last = neighbours_.begin() + neighbours_begin_[block + 1];
      if (std::any_of(first, last, [&](std::int32_t v) { return vertex_mark_[v] != 0; })) {
        list.push_back(static_cast<std::int32_t>(block));
      }
    }
  };

  for (std::size_t block = 0; block < vertex_mark_.size(); ++block) {
    const auto first = needed.begin() + static_cast<std::ptrdiff_t>(block * vertices_per_block);
    const auto last = first + std::min<std::ptrdiff_t>(vertices_per_block, needed.end() - first);
    vertex_mark_[block] = std::any_of(first, last, [](std::uint8_t is_needed) { return is_needed != 0; });
  }
  list_marked_vertices(force_vertices_);
  list_triangles_at_marks(force_triangles_);
  for (const std::int32_t block : force_triangles_) {
    for (std::int32_t n = neighbours_begin_[block]; n < neighbours_begin_[block + 1]; ++n) {
      vertex_mark_[neighbours_[n]] = 1;
    }
  }
  list_marked_vertices(curvature_vertices_);
  list_triangles_at_marks(curvature_triangles_);
}

}  // namespace rouleau
