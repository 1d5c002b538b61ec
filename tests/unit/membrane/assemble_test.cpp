// SPDX-License-Identifier: BSD-3-Clause
// Concatenating cells.
#include "membrane/assemble.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/error.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

TEST(MembraneAssemble, KeepsEachCellInItsRange) {
  const std::vector<CellStart> starts{{sphere(2, 3), {}}, {red_blood_cell(3, 4), {}}};
  const Cells cells = assemble(starts);
  ASSERT_EQ(cells.ranges.size(), 2u);
  EXPECT_EQ(cells.ranges[1].vertex_begin, 162);
  EXPECT_EQ(cells.ranges[1].triangle_begin, 320);
  EXPECT_EQ(static_cast<std::size_t>(cells.ranges[1].vertex_end), cells.vertices());
  EXPECT_EQ(static_cast<std::size_t>(cells.ranges[1].triangle_end), cells.triangles.size());
  for (std::size_t cell = 0; cell < 2; ++cell) EXPECT_EQ(volume(cells, cell), cells.ranges[cell].volume_0);
  EXPECT_EQ(cells.F.size(), cells.vertices());
  EXPECT_EQ(cells.images.size(), 2u);
}

TEST(MembraneAssemble, ListsEachVertexsTrianglesInAscendingOrder) {
  const Surface shape = red_blood_cell(2, 4);
  const VertexTriangles around = triangles_around(shape.triangles, shape.X.size());
  std::size_t corners = 0;
  for (std::size_t v = 0; v < shape.X.size(); ++v) {
    for (std::int32_t i = around.begin[v]; i < around.begin[v + 1]; ++i, ++corners) {
      const auto t = static_cast<std::size_t>(around.triangle[i]);
      const std::int32_t corner[3] = {shape.triangles.a[t], shape.triangles.b[t], shape.triangles.c[t]};
      EXPECT_EQ(corner[around.corner[i]], static_cast<std::int32_t>(v));
      if (i > around.begin[v]) {
        EXPECT_GT(around.triangle[i], around.triangle[i - 1]);
      }
    }
  }
  EXPECT_EQ(corners, 3 * shape.triangles.size());
}

TEST(MembraneAssemble, TakesVolumeAndAreaFromTheReferenceIfGiven) {
  Surface swollen = sphere(2, 3);
  scale(swollen, 1.1);
  const CellStart start{swollen, sphere(2, 3)};
  const Cells cells = assemble({&start, 1});
  EXPECT_EQ(cells.ranges[0].volume_0, volume(sphere(2, 3)));
  EXPECT_EQ(cells.ranges[0].area_0, area(sphere(2, 3)));
}

TEST(MembraneAssemble, RefusesAReferenceWithOtherTriangles) {
  const CellStart start{sphere(2, 3), sphere(3, 3)};
  EXPECT_THROW(assemble({&start, 1}), Error);
}

}  // namespace
}  // namespace rouleau
