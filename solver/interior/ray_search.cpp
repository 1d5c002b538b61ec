// SPDX-License-Identifier: BSD-3-Clause
#include "interior/ray_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rouleau {
namespace {

/// Far above the rounding of a crossing's position, far below a triangle's size: a triangle that a ray may cross, after
/// all rounding, stands in the ray's column.
constexpr double margin = 1e-6;

std::array<V3, 3> corners(const Cells& cells, std::int32_t t) {
  const ConstV3s X(cells.X);
  const auto i = static_cast<std::size_t>(t);
  return {X[cells.triangles.a[i]], X[cells.triangles.b[i]], X[cells.triangles.c[i]]};
}

ImageBox box_around(const Cells& cells, const CellRange& range) {
  constexpr double far = std::numeric_limits<double>::max();
  ImageBox box{Vec3::Constant(far), Vec3::Constant(-far)};
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    const Vec3 X = at(cells.X, static_cast<std::size_t>(v));
    box.low = box.low.cwiseMin(X);
    box.high = box.high.cwiseMax(X);
  }
  return box;
}

}  // namespace

CellForRays::CellForRays(const Cells& cells, const CellRange& range, RaySearch search)
    : search_(search), box_(box_around(cells, range)) {
  if (search == RaySearch::direct)
    fill_row(cells, range);
  else
    fill_columns(cells, range);
}

CellForRays::Foot CellForRays::foot(V3 point) {
  return {point.x - point.z * (ray_direction.x / ray_direction.z),
          point.y - point.z * (ray_direction.y / ray_direction.z)};
}

void CellForRays::fill_row(const Cells& cells, const CellRange& range) {
  const std::int32_t count = range.triangle_end - range.triangle_begin;
  triangles_.resize(static_cast<std::size_t>(count));
  for (std::int32_t t = 0; t < count; ++t) {
    const auto [a, b, c] = corners(cells, range.triangle_begin + t);
    triangles_.set(static_cast<std::size_t>(t), prepare_for_rays(a, b, c));
  }
  begin_ = {0, count};
}

void CellForRays::fill_columns(const Cells& cells, const CellRange& range) {
  constexpr double far = std::numeric_limits<double>::max();
  low_ = {far, far};
  Foot high{-far, -far};
  const ConstV3s X(cells.X);
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    const Foot f = foot(X[v]);
    low_ = {std::min(low_.x, f.x - margin), std::min(low_.y, f.y - margin)};
    high = {std::max(high.x, f.x + margin), std::max(high.y, f.y + margin)};
  }
  // About as many columns as a side of the cell has triangles: a column then holds a few of each side.
  const double area = (high.x - low_.x) * (high.y - low_.y);
  columns_per_length_ = std::sqrt(0.5 * (range.triangle_end - range.triangle_begin) / area);
  columns_x_ = static_cast<int>((high.x - low_.x) * columns_per_length_) + 1;
  columns_y_ = static_cast<int>((high.y - low_.y) * columns_per_length_) + 1;

  const auto for_each_column = [&](std::int32_t t, auto visit) {
    const auto [a, b, c] = corners(cells, t);
    const Foot fa = foot(a), fb = foot(b), fc = foot(c);
    const auto [x_low, x_high] = std::minmax({fa.x, fb.x, fc.x});
    const auto [y_low, y_high] = std::minmax({fa.y, fb.y, fc.y});
    const int x_begin = column_of(x_low - margin, low_.x, columns_x_);
    const int x_end = column_of(x_high + margin, low_.x, columns_x_);
    const int y_begin = column_of(y_low - margin, low_.y, columns_y_);
    const int y_end = column_of(y_high + margin, low_.y, columns_y_);
    for (int y = y_begin; y <= y_end; ++y)
      for (int x = x_begin; x <= x_end; ++x) visit(static_cast<std::size_t>(y * columns_x_ + x));
  };

  begin_.assign(static_cast<std::size_t>(columns_x_) * static_cast<std::size_t>(columns_y_) + 1, 0);
  for (std::int32_t t = range.triangle_begin; t < range.triangle_end; ++t)
    for_each_column(t, [&](std::size_t column) { ++begin_[column + 1]; });
  for (std::size_t column = 1; column < begin_.size(); ++column) begin_[column] += begin_[column - 1];
  triangles_.resize(static_cast<std::size_t>(begin_.back()));
  std::vector<std::int64_t> next(begin_.begin(), begin_.end() - 1);
  for (std::int32_t t = range.triangle_begin; t < range.triangle_end; ++t) {
    const auto [a, b, c] = corners(cells, t);
    const RayTriangle ready = prepare_for_rays(a, b, c);
    for_each_column(t, [&](std::size_t column) { triangles_.set(static_cast<std::size_t>(next[column]++), ready); });
  }
}

int CellForRays::column_of(double along, double low, int count) const {
  return std::clamp(static_cast<int>((along - low) * columns_per_length_), 0, count - 1);
}

bool CellForRays::contains(const Vec3& point) const {
  const V3 origin = to_v3(point);
  if (search_ == RaySearch::direct) return triangles_.crosses_odd(origin, begin_.front(), begin_.back());
  const Foot f = foot(origin);
  const double x = (f.x - low_.x) * columns_per_length_, y = (f.y - low_.y) * columns_per_length_;
  if (!(x >= 0.0 && x < columns_x_ && y >= 0.0 && y < columns_y_)) return false;
  const auto column = static_cast<std::size_t>(static_cast<int>(y) * columns_x_ + static_cast<int>(x));
  return triangles_.crosses_odd(origin, begin_[column], begin_[column + 1]);
}

}  // namespace rouleau
