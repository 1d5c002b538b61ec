// SPDX-License-Identifier: BSD-3-Clause
// The wall rule along one axis.
#include "coupling/walls.hpp"

#include <gtest/gtest.h>

#include <map>

namespace rouleau {
namespace {

constexpr int n = 8;
constexpr std::array<double, 4> weights{0.5, 0.25, 0.125, 0.0625};  // told apart by their bits; sums are exact

std::map<int, double> by_node(const AxisStencil<4>& s) {
  std::map<int, double> map;
  for (int a = 0; a < 4; ++a)
    if (s.weight[static_cast<std::size_t>(a)] != 0) map[s.first + a] = s.weight[static_cast<std::size_t>(a)];
  return map;
}

TEST(WallRule, ReflectsTheFirstTwoNodesBeyondTheLowWall) {
  // Nodes -2 -1 | 0 1: -1 goes to 0, -2 to 1.
  EXPECT_EQ(by_node(reflected<4>(-2, weights.data(), n)), (std::map<int, double>{{0, 0.375}, {1, 0.5625}}));
}

TEST(WallRule, ReflectsTheFirstTwoNodesBeyondTheHighWall) {
  // Nodes 6 7 | 8 9: 8 goes to 7, 9 to 6.
  EXPECT_EQ(by_node(reflected<4>(6, weights.data(), n)), (std::map<int, double>{{6, 0.5625}, {7, 0.375}}));
}

TEST(WallRule, DropsWhatFallsBeyondAWall) {
  const auto low = dropped<4>(-1, weights.data(), n);
  EXPECT_EQ(by_node(low), (std::map<int, double>{{0, 0.25}, {1, 0.125}, {2, 0.0625}}));
  EXPECT_EQ(low.beyond, (std::array<double, 2>{0.5, 0.0}));
  const auto high = dropped<4>(5, weights.data(), n);
  EXPECT_EQ(by_node(high), (std::map<int, double>{{5, 0.5}, {6, 0.25}, {7, 0.125}}));
  EXPECT_EQ(high.beyond, (std::array<double, 2>{0.0, 0.0625}));
}

TEST(WallRule, LeavesAStencilAwayFromWallsAlone) {
  const std::map<int, double> untouched{{2, 0.5}, {3, 0.25}, {4, 0.125}, {5, 0.0625}};
  EXPECT_EQ(by_node(reflected<4>(2, weights.data(), n)), untouched);
  EXPECT_EQ(by_node(dropped<4>(2, weights.data(), n)), untouched);
}

TEST(WallRule, FitsTheNarrowestChannel) {
  // As many nodes as the kernel has: a vertex near one wall then never reaches the other.
  EXPECT_EQ(by_node(reflected<4>(-2, weights.data(), 4)), (std::map<int, double>{{0, 0.375}, {1, 0.5625}}));
  EXPECT_EQ(by_node(reflected<4>(2, weights.data(), 4)), (std::map<int, double>{{2, 0.5625}, {3, 0.375}}));
}

}  // namespace
}  // namespace rouleau
