// SPDX-License-Identifier: BSD-3-Clause
// One cell made ready for rays: all its triangles in a row, or sorted into columns along the rays.
#pragma once

#include <vector>

#include "interior/image_nodes.hpp"
#include "interior/ray_cast.hpp"
#include "interior/ray_triangles.hpp"

namespace rouleau {

/// Answers for one cell at a time whether a point of periodic space's one image is inside.
class CellForRays {
 public:
  CellForRays(const Cells& cells, const CellRange& range, RaySearch search);

  /// Around the cell's vertices.
  [[nodiscard]] const ImageBox& box() const { return box_; }
  [[nodiscard]] bool contains(const Vec3& point) const;

 private:
  /// What a ray along `ray_direction` keeps: where it meets the plane z = 0.
  struct Foot {
    double x, y;
  };
  static Foot foot(V3 point);

  void fill_row(const Cells& cells, const CellRange& range);
  void fill_columns(const Cells& cells, const CellRange& range);
  [[nodiscard]] int column_of(double along, double low, int count) const;

  RaySearch search_;
  ImageBox box_;
  RayTriangles triangles_;
  Foot low_{0, 0};                 ///< corner of the columns' grid
  double columns_per_length_ = 0;  ///< columns are square
  int columns_x_ = 0, columns_y_ = 0;
  /// [columns + 1] slots of triangles_ where each column begins; a triangle stands in each column that it touches.
  std::vector<std::int64_t> begin_;
};

}  // namespace rouleau
