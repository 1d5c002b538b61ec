// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of triangles and vertices must be computed so that the forces of the needed vertices come out whole.
#include "membrane/work_blocks.hpp"

#include <algorithm>
#include <numeric>

namespace rouleau {
namespace {

constexpr std::size_t blocks_of(std::size_t count) { return (count + WorkBlocks::size - 1) / WorkBlocks::size; }

void list_all(std::vector<std::int32_t>& blocks, std::size_t count) {
  blocks.resize(count);
  std::iota(blocks.begin(), blocks.end(), 0);
}

}  // namespace

WorkBlocks::WorkBlocks(const Cells& cells) : corners_begin_{0}, mark_(cells.vertices()) {
  const std::size_t triangles = cells.triangles.size();
  for (std::size_t first = 0; first < triangles; first += size) {
    std::vector<std::int32_t> touched;
    for (std::size_t t = first; t < std::min(first + size, triangles); ++t) {
      for (const std::int32_t v : {cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]}) {
        touched.push_back(v);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    corners_.insert(corners_.end(), touched.begin(), touched.end());
    corners_begin_.push_back(static_cast<std::int32_t>(corners_.size()));
  }
  for (auto* list : {&curvature_triangles_, &force_triangles_}) list->reserve(blocks_of(triangles));
  for (auto* list : {&curvature_vertices_, &force_vertices_}) list->reserve(blocks_of(mark_.size()));
}

void WorkBlocks::select(std::span<const std::uint8_t> needed) {
  if (needed.empty()) {
    for (auto* list : {&curvature_triangles_, &force_triangles_}) list_all(*list, corners_begin_.size() - 1);
    for (auto* list : {&curvature_vertices_, &force_vertices_}) list_all(*list, blocks_of(mark_.size()));
    return;
  }
  std::copy(needed.begin(), needed.end(), mark_.begin());
  list_marked_vertices(force_vertices_);
  list_triangles_at_marks(force_triangles_);
  for (const std::int32_t block : force_triangles_) {
    for (std::int32_t i = corners_begin_[block]; i < corners_begin_[block + 1]; ++i) mark_[corners_[i]] = 1;
  }
  list_marked_vertices(curvature_vertices_);
  list_triangles_at_marks(curvature_triangles_);
}

void WorkBlocks::list_marked_vertices(std::vector<std::int32_t>& blocks) const {
  blocks.clear();
  for (std::size_t first = 0; first < mark_.size(); first += size) {
    const auto begin = mark_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min<std::size_t>(size, mark_.size() - first));
    if (std::find_if(begin, end, [](std::uint8_t mark) { return mark != 0; }) != end) {
      blocks.push_back(static_cast<std::int32_t>(first / size));
    }
  }
}

void WorkBlocks::list_triangles_at_marks(std::vector<std::int32_t>& blocks) const {
  blocks.clear();
  for (std::size_t block = 0; block + 1 < corners_begin_.size(); ++block) {
    const auto begin = corners_.begin() + corners_begin_[block], end = corners_.begin() + corners_begin_[block + 1];
    if (std::any_of(begin, end, [&](std::int32_t v) { return mark_[v] != 0; })) {
      blocks.push_back(static_cast<std::int32_t>(block));
    }
  }
}

}  // namespace rouleau
