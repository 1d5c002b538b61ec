// SPDX-License-Identifier: BSD-3-Clause
// Cells that leave through a periodic face.
#include "membrane/wrap.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "membrane/measures.hpp"
#include "membrane/transform.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

Lattice channel() {
  Lattice lattice;
  lattice.size = {128, 36, 30};
  lattice.periodic = {true, false, false};
  return lattice;
}

Surface at_position(const Vec3& position) {
  Surface s = sphere(2, 5);
  translate(s, position);
  return s;
}

TEST(MembraneWrap, MovesACellBackAndCountsIt) {
  const std::vector<CellStart> starts{{at_position({127.6, 18, 15}), {}},
                                      {at_position({-0.6, 18, 15}), {}},
                                      {at_position({127.4, 18, 15}), {}},
                                      {at_position({-300, 18, 15}), {}}};
  Cells cells = assemble(starts);
  wrap_cells(cells, channel());
  const double expected_x[] = {-0.4, 127.4, 127.4, 84};
  const int expected_images[] = {1, -1, 0, -3};
  for (std::size_t cell = 0; cell < starts.size(); ++cell) {
    EXPECT_NEAR(vertex_mean(cells.X, cells.ranges[cell])[0], expected_x[cell], 1e-12);
    EXPECT_EQ(cells.images[cell], (Int3{expected_images[cell], 0, 0}));
  }
}

TEST(MembraneWrap, KeepsTheUnwrappedPathAndTheShape) {
  const Surface start = at_position({200.25, 18, 15});
  Cells cells = test::one_cell(start);
  wrap_cells(cells, channel());
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    EXPECT_NEAR(cells.X.x[v] + cells.images[0][0] * 128, start.X.x[v], 1e-13);
  }
  const VectorArray once = cells.X;
  wrap_cells(cells, channel());
  EXPECT_EQ(cells.X.x, once.x);
}

TEST(MembraneWrap, LeavesWalledAxesAlone) {
  Cells cells = test::one_cell(at_position({60, 500, -100}));
  const VectorArray before = cells.X;
  wrap_cells(cells, channel());
  EXPECT_EQ(cells.X.y, before.y);
  EXPECT_EQ(cells.X.z, before.z);
  EXPECT_EQ(cells.images[0], (Int3{0, 0, 0}));
}

}  // namespace
}  // namespace rouleau
