// SPDX-License-Identifier: BSD-3-Clause
// Volume, area, and the shift that restores the volume.
#include "membrane/volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "membrane/transform.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;
using test::strongly_deformed;

Surface tetrahedron() {
  Surface s;
  s.X.x = {0, 3, 0, 0};
  s.X.y = {0, 0, 2, 0};
  s.X.z = {0, 0, 0, 1};
  s.triangles.a = {0, 0, 0, 1};
  s.triangles.b = {2, 1, 3, 2};
  s.triangles.c = {1, 3, 2, 3};
  return s;
}

TEST(MembraneVolume, TetrahedronHasItsVolumeAndAreaAnywhere) {
  Surface s = tetrahedron();
  EXPECT_DOUBLE_EQ(volume(s), 1);
  EXPECT_DOUBLE_EQ(area(s), 3 + 1.5 + 1 + 3.5);  // three right triangles and one with |N| = 7
  translate(s, {1000, -1000, 500});
  EXPECT_NEAR(volume(s), 1, 1e-12);
}

TEST(MembraneVolume, ShiftRestoresEveryCell) {
  std::vector<CellStart> starts;
  for (const double factor : {0.97, 1.0, 1.00001, 1.03}) {
    Surface shape = red_blood_cell(3, 12);
    scale(shape, factor);
    translate(shape, {60 * factor, 18, 15});
    starts.push_back({shape, red_blood_cell(3, 12)});
  }
  starts.push_back({strongly_deformed(red_blood_cell(2, 4), 0.01), {}});
  Cells cells = assemble(starts);
  cells.ranges[4].volume_0 *= 1.01;
  VolumeShift shift(cells);
  EXPECT_NEAR(shift.restore(cells), 1.03 * 1.03 * 1.03 - 1, 1e-9);
  for (std::size_t cell = 0; cell < starts.size(); ++cell) {
    EXPECT_LT(std::abs(volume(cells, cell) / cells.ranges[cell].volume_0 - 1), 1e-12);
  }
}

TEST(MembraneVolume, ShiftRestoresLeaksOfEverySize) {
  // Below 1e-7 one correction is made without looking again; a crumpled cell is far from a sphere, for which that is
  // safest.
  for (const double leak : {1e-12, 1e-10, 1e-8, 0.99e-7, 1.01e-7, 1e-6, 1e-4, -0.99e-7, -1e-4}) {
    Cells cells = one_cell(strongly_deformed(red_blood_cell(4, 12), 0.03));
    cells.ranges[0].volume_0 *= 1 + leak;
    VolumeShift(cells).restore(cells);
    EXPECT_LT(std::abs(volume(cells, 0) / cells.ranges[0].volume_0 - 1), 2e-13) << leak;  // tolerance and round-off
  }
}

TEST(MembraneVolume, ShiftFollowsTheGradientOfTheVolume) {
  Cells cells = one_cell(strongly_deformed(red_blood_cell(2, 4), 0.02));
  const VectorArray minus_gradient = test::numerical_force(cells, 1e-3, [&] { return volume(cells, 0); });
  const VectorArray before = cells.X;
  cells.ranges[0].volume_0 *= 1.001;
  VolumeShift(cells).restore(cells);
  double along = 0, gradient = 0, moved = 0;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const Vec3 d = at(cells.X, v) - at(before, v);
    along -= d.dot(at(minus_gradient, v));
    gradient += at(minus_gradient, v).squaredNorm();
    moved += d.squaredNorm();
  }
  EXPECT_NEAR(along / std::sqrt(gradient * moved), 1, 1e-10);  // parallel; differences carry round-off over h
}

TEST(MembraneVolume, ShiftKeepsTheMeanDirectionless) {
  // The gradients of a closed mesh add up to zero: the shift does not move the mean of the vertices.
  Cells cells = one_cell(strongly_deformed(red_blood_cell(3, 4), 0.01));
  const Vec3 before = test::total(cells.X);
  cells.ranges[0].volume_0 *= 1.02;
  VolumeShift(cells).restore(cells);
  EXPECT_LT((test::total(cells.X) - before).norm(), 1e-11);
}

TEST(MembraneVolume, BitsDoNotDependOnNeighbourCells) {
  const std::vector<CellStart> starts{{sphere(1, 3), {}}, {strongly_deformed(red_blood_cell(3, 4), 0.01), {}}};
  Cells pair = assemble(starts);
  Cells alone = one_cell(starts[1].shape);
  pair.ranges[1].volume_0 *= 1.001;
  alone.ranges[0].volume_0 *= 1.001;
  VolumeShift(pair).restore(pair);
  VolumeShift(alone).restore(alone);
  const auto begin = static_cast<std::size_t>(pair.ranges[1].vertex_begin);
  for (std::size_t v = 0; v < alone.vertices(); ++v) EXPECT_EQ(at(pair.X, begin + v), at(alone.X, v));
}

TEST(MembraneVolume, LostVolumeEndsTheRun) {
  Cells cells = one_cell(sphere(2, 3));
  cells.ranges[0].volume_0 *= 1.2;
  try {
    VolumeShift(cells).restore(cells);
    FAIL() << "a volume off by 20 % was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
  }
  cells.X.x[5] = std::nan("");
  EXPECT_THROW(VolumeShift(cells).restore(cells), Error);
}

}  // namespace
}  // namespace rouleau
