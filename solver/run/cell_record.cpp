// SPDX-License-Identifier: BSD-3-Clause
#include "run/cell_record.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>

namespace rouleau {

namespace {

void pack_vectors(const VectorArray& from, std::vector<double>& to) {
  const std::size_t n = from.size();
  std::copy_n(from.x.begin(), n, to.begin());
  std::copy_n(from.y.begin(), n, to.begin() + static_cast<std::ptrdiff_t>(n));
  std::copy_n(from.z.begin(), n, to.begin() + static_cast<std::ptrdiff_t>(2 * n));
}

void unpack_vectors(const std::vector<double>& from, VectorArray& to) {
  const std::size_t n = to.size();
  std::copy_n(from.begin(), n, to.x.begin());
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(n), n, to.y.begin());
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(2 * n), n, to.z.begin());
}

}  // namespace

CellRecord::CellRecord(const Cells& cells)
    : vertices_(cells.vertices()),
      triangles_(cells.triangles.size()),
      cells_(cells.ranges.size()),
      X_(3 * vertices_),
      X_reference_(3 * vertices_),
      U_(3 * vertices_),
      U_previous_(3 * vertices_),
      size_(2 * cells_),
      corners_(3 * triangles_),
      ranges_(4 * cells_),
      images_(3 * cells_) {
  pack(cells);
}

void CellRecord::pack(const Cells& cells) {
  pack_vectors(cells.X, X_);
  pack_vectors(cells.X_reference, X_reference_);
  pack_vectors(cells.U, U_);
  pack_vectors(cells.U_previous, U_previous_);
  auto corner = corners_.begin();
  for (const auto* side : {&cells.triangles.a, &cells.triangles.b, &cells.triangles.c})
    corner = std::copy_n(side->begin(), triangles_, corner);
  for (std::size_t c = 0; c < cells_; ++c) {
    const CellRange& r = cells.ranges[c];
    const std::array<std::int32_t, 4> bounds{r.vertex_begin, r.vertex_end, r.triangle_begin, r.triangle_end};
    std::copy(bounds.begin(), bounds.end(), ranges_.begin() + static_cast<std::ptrdiff_t>(4 * c));
    std::copy(cells.images[c].begin(), cells.images[c].end(), images_.begin() + static_cast<std::ptrdiff_t>(3 * c));
    size_[2 * c] = r.volume_0;
    size_[2 * c + 1] = r.area_0;
  }
}

void CellRecord::unpack(Cells& cells) const {
  unpack_vectors(X_, cells.X);
  unpack_vectors(U_, cells.U);
  unpack_vectors(U_previous_, cells.U_previous);
  for (std::size_t c = 0; c < cells_; ++c)
    std::copy_n(images_.begin() + static_cast<std::ptrdiff_t>(3 * c), 3, cells.images[c].begin());
}

bool CellRecord::has_same_mesh(const Cells& cells) const {
  const CellRecord other(cells);
  return corners_ == other.corners_ && ranges_ == other.ranges_ && X_reference_ == other.X_reference_ &&
         size_ == other.size_;
}

std::string CellRecord::mesh_digest() const {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(state.get());
  XXH3_64bits_update(state.get(), corners_.data(), corners_.size() * sizeof(corners_[0]));
  XXH3_64bits_update(state.get(), ranges_.data(), ranges_.size() * sizeof(ranges_[0]));
  XXH3_64bits_update(state.get(), X_reference_.data(), X_reference_.size() * sizeof(X_reference_[0]));
  return fmt::format("{:016x}", XXH3_64bits_digest(state.get()));
}

void CellRecord::append_items(std::vector<ReplicatedItem>& items) {
  using enum ElementType;
  items.push_back({"cells/X", f64, {3, vertices_}, X_.data()});
  items.push_back({"cells/U", f64, {3, vertices_}, U_.data()});
  items.push_back({"cells/U_previous", f64, {3, vertices_}, U_previous_.data()});
  items.push_back({"cells/X_reference", f64, {3, vertices_}, X_reference_.data()});
  items.push_back({"cells/triangles", i32, {3, triangles_}, corners_.data()});
  items.push_back({"cells/ranges", i32, {cells_, 4}, ranges_.data()});
  items.push_back({"cells/volume_and_area_at_rest", f64, {cells_, 2}, size_.data()});
  items.push_back({"cells/images", i32, {cells_, 3}, images_.data()});
}

}  // namespace rouleau
