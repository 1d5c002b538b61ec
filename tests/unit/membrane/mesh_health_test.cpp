// SPDX-License-Identifier: BSD-3-Clause
// Faults planted into a mesh are found and named; sound meshes pass.
#include "membrane/mesh_health.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;
using test::strongly_deformed;
using testing::HasSubstr;

TEST(MembraneHealth, SoundCellsHaveNoFault) {
  for (const Surface& shape : {sphere(2, 3), red_blood_cell(4, 12), strongly_deformed(red_blood_cell(3, 4), 0.01)}) {
    const Cells cells = one_cell(shape);
    EXPECT_FALSE(MeshHealth(cells).find_fault(cells).has_value());
  }
}

TEST(MembraneHealth, NamesAVertexThatIsNotFinite) {
  const std::vector<CellStart> starts{{sphere(2, 3), {}}, {sphere(2, 3), {}}};
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Cells cells = assemble(starts);
    MeshHealth health(cells);
    cells.X.y[162 + 7] = bad;
    const auto fault = health.find_fault(cells);
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->cell, 1u);
    EXPECT_THAT(fault->what, HasSubstr("vertex 7 is not finite"));
  }
}

TEST(MembraneHealth, NamesAFoldedTriangle) {
  const std::vector<CellStart> starts{{sphere(2, 3), {}}, {red_blood_cell(3, 4), {}}};
  Cells cells = assemble(starts);
  MeshHealth health(cells);
  // A vertex drawn over the far edge of a triangle around it turns that triangle over.
  const std::size_t first = 320, t = 320 + 100;
  const auto a = static_cast<std::size_t>(cells.triangles.a[t]);
  const Vec3 far_edge = 0.5 * (at(cells.X, cells.triangles.b[t]) + at(cells.X, cells.triangles.c[t])) - at(cells.X, a);
  set(cells.X, a, at(cells.X, a) + 1.8 * far_edge);
  const auto fault = health.find_fault(cells);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->cell, 1u);
  EXPECT_THAT(fault->what, HasSubstr("folded"));
  const std::size_t found = first + fault->triangle;
  bool touches = false;
  for (const std::int32_t v : {cells.triangles.a[found], cells.triangles.b[found], cells.triangles.c[found],
                               cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]}) {
    touches = touches || v == static_cast<std::int32_t>(a);
  }
  EXPECT_TRUE(touches);
}

TEST(MembraneHealth, NamesACollapsedTriangle) {
  Cells cells = one_cell(sphere(2, 3));
  MeshHealth health(cells);
  const std::size_t t = 33;
  const Vec3 middle = 0.5 * (at(cells.X, cells.triangles.b[t]) + at(cells.X, cells.triangles.c[t]));
  const auto a = static_cast<std::size_t>(cells.triangles.a[t]);
  set(cells.X, a, middle + 0.005 * (at(cells.X, a) - middle));
  const auto fault = health.find_fault(cells, {.fold_cosine = -2, .collapse_area_ratio = 0.02});
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->triangle, t);
  EXPECT_THAT(fault->what, HasSubstr("collapsed"));
  EXPECT_FALSE(health.find_fault(cells, {.fold_cosine = -2, .collapse_area_ratio = 0.001}).has_value());
}

}  // namespace
}  // namespace rouleau
