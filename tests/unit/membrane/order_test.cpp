// SPDX-License-Identifier: BSD-3-Clause
// Renumbering a mesh along a space-filling curve.
#include "membrane/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "membrane/check_surface.hpp"
#include "membrane/shapes.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

MeshOrder random_order(const Surface& surface) {
  MeshOrder order;
  order.triangle.resize(surface.triangles.size());
  order.vertex.resize(surface.X.size());
  std::iota(order.triangle.begin(), order.triangle.end(), 0);
  std::iota(order.vertex.begin(), order.vertex.end(), 0);
  std::mt19937 random(7);
  std::shuffle(order.triangle.begin(), order.triangle.end(), random);
  std::shuffle(order.vertex.begin(), order.vertex.end(), random);
  return order;
}

double mean_index_distance(const Surface& surface) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    sum += std::abs(surface.triangles.a[t] - surface.triangles.b[t]);
  }
  return sum / static_cast<double>(surface.triangles.size());
}

TEST(MembraneOrder, BringsNeighboursOfAShuffledMeshTogether) {
  const Surface shape = red_blood_cell(4, 4);
  const Surface shuffled = reordered(shape, random_order(shape));
  const Surface ordered = reordered(shuffled, space_curve_order(shuffled));
  EXPECT_GT(mean_index_distance(shuffled), 600);  // a third of 2562
  EXPECT_LT(mean_index_distance(ordered), 150);
  EXPECT_NO_THROW(check_surface(ordered, "ordered"));
  EXPECT_NEAR(volume(ordered), volume(shape), 1e-12 * volume(shape));  // another order of summation
}

TEST(MembraneOrder, IsAPermutation) {
  const Surface shape = red_blood_cell(2, 4);
  MeshOrder order = space_curve_order(shape);
  std::sort(order.triangle.begin(), order.triangle.end());
  std::sort(order.vertex.begin(), order.vertex.end());
  for (std::size_t i = 0; i < order.triangle.size(); ++i) EXPECT_EQ(order.triangle[i], static_cast<std::int32_t>(i));
  for (std::size_t i = 0; i < order.vertex.size(); ++i) EXPECT_EQ(order.vertex[i], static_cast<std::int32_t>(i));
  EXPECT_EQ(order.triangle.size(), shape.triangles.size());
  EXPECT_EQ(order.vertex.size(), shape.X.size());
}

}  // namespace
}  // namespace rouleau
