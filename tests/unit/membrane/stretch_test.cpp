// SPDX-License-Identifier: BSD-3-Clause
// The forces that pull the ends of cells apart: which vertices, how much, and that nothing is left over.
#include "membrane/stretch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/transform.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;
using test::total;

double coordinate(const VectorArray& X, std::int32_t v, std::size_t axis) {
  return at(X, static_cast<std::size_t>(v))[static_cast<Eigen::Index>(axis)];
}

TEST(MembraneStretch, EndsAreTheVerticesFarthestOut) {
  Surface shape = red_blood_cell(3, 12);
  rotate(shape, {1, 2, 0.5}, 0.7);
  translate(shape, {30, 20, 10});
  const auto n = static_cast<std::int32_t>(shape.X.size());
  for (const std::size_t axis : {0, 1, 2}) {
    const auto [low, high] = end_vertices(shape.X, 0, n, axis, 0.05);
    EXPECT_EQ(low.size(), 32u);  // 642 x 0.05, no two vertices of a turned cell lie equally far out
    EXPECT_EQ(high.size(), 32u);
    double innermost = coordinate(shape.X, high[0], axis);
    for (const std::int32_t v : high) innermost = std::min(innermost, coordinate(shape.X, v, axis));
    for (std::int32_t v = 0; v < n; ++v) {
      const bool is_pulled = std::find(high.begin(), high.end(), v) != high.end();
      EXPECT_EQ(is_pulled, coordinate(shape.X, v, axis) >= innermost);
    }
  }
}

TEST(MembraneStretch, SymmetricCellHasSymmetricEnds) {
  Surface shape = red_blood_cell(4, 12);
  translate(shape, {31.7, 20.3, 10.1});
  for (const double share : {0.01, 0.02, 0.05, 0.1}) {
    const auto n = static_cast<std::int32_t>(shape.X.size());
    const auto ends = end_vertices(shape.X, 0, n, 0, share);
    EXPECT_EQ(ends[0].size(), ends[1].size());
    EXPECT_GE(ends[0].size(), static_cast<std::size_t>(share * n));
    EXPECT_LE(ends[0].size(), static_cast<std::size_t>(share * n) + 8);
    // The ends' mean points lie on a line along the axis: the pull does not turn the cell.
    for (const std::size_t across : {1, 2})
      for (const auto& end : ends) {
        double sum = 0;
        for (const std::int32_t v : end) sum += coordinate(shape.X, v, across) - (across == 1 ? 20.3 : 10.1);
        EXPECT_NEAR(sum, 0, 1e-10);  // round-off of some 250 coordinates near 20
      }
  }
}

TEST(MembraneStretch, SharesTheForceAndLeavesNothingOver) {
  const std::vector<CellStart> starts{{red_blood_cell(3, 12), std::nullopt}, {sphere(2, 7), std::nullopt}};
  const Cells cells = assemble(starts);
  const Stretch stretch(cells, 1, 0.03);
  VectorArray F(cells.vertices());
  stretch.add(F, 2.5);
  EXPECT_LT(total(F).norm(), 1e-14);  // round-off of a sum of 2.5
  for (const CellRange& range : cells.ranges) {
    double pulled_up = 0;
    for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
      EXPECT_EQ(F.x[v], 0);
      EXPECT_EQ(F.z[v], 0);
      if (F.y[v] > 0) pulled_up += F.y[v];
      if (F.y[v] != 0) {
        EXPECT_EQ(F.y[v] > 0, cells.X.y[v] > 0);
      }
    }
    EXPECT_NEAR(pulled_up, 2.5, 1e-14);
  }
}

TEST(MembraneStretch, KeepsItsVerticesWhenTheCellTurns) {
  Cells cells = one_cell(red_blood_cell(3, 12));
  const Stretch stretch(cells, 0, 0.05);
  VectorArray before(cells.vertices()), after(cells.vertices());
  stretch.add(before, 1);
  std::swap(cells.X.x, cells.X.y);
  stretch.add(after, 1);
  EXPECT_EQ(before.x, after.x);
}

TEST(MembraneStretch, SmallestShareIsOneVertex) {
  const Surface shape = test::strongly_deformed(sphere(2, 7), 0.01);
  const auto ends = end_vertices(shape.X, 0, static_cast<std::int32_t>(shape.X.size()), 2, 1e-4);
  EXPECT_EQ(ends[0].size(), 1u);
  EXPECT_EQ(ends[1].size(), 1u);
}

}  // namespace
}  // namespace rouleau
