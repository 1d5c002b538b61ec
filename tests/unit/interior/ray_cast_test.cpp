// SPDX-License-Identifier: BSD-3-Clause
// Ray casting: the fast form against the paper's direct one, both against geometry.
#include "interior/ray_cast.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "interior/analytic.hpp"
#include "interior/ray_triangles.hpp"
#include "meshes.hpp"

namespace rouleau {
namespace {

using testing::cells_of;
using testing::cut;
using testing::cuts;
using testing::differences;
using testing::differences_on_block;
using testing::flags_on;
using testing::posed;
using testing::whole;

const Lattice box{{30, 28, 26}, {true, true, true}};
const Lattice channel{{30, 28, 26}, {true, false, false}};

Flags rays(const Cells& cells, const Lattice& lattice, RaySearch search) {
  Flags flags = flags_on(whole(lattice));
  cast_rays(cells, lattice, whole(lattice), search, flags);
  return flags;
}

/// A cell bent, stretched and dented, so that rays cross it up to six times.
Surface crumpled(Surface surface) {
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    Vec3 X = at(surface.X, v);
    X[2] += 0.06 * X[0] * X[0] - 0.8 * std::sin(1.1 * X[1]);
    X[0] *= 1.1;
    set(surface.X, v, X);
  }
  return surface;
}

TEST(RayTriangle, IsCrossedByRaysThatPointAtItOnly) {
  const RayTriangle triangle = prepare_for_rays({-1, -1, 5}, {2, -1, 5}, {-1, 2, 5});
  EXPECT_TRUE(crosses({0, 0, 0}, triangle));
  EXPECT_FALSE(crosses({0, 0, 6}, triangle)) << "behind the origin";
  EXPECT_FALSE(crosses({2, 2, 0}, triangle)) << "beside it";
}

TEST(RayTriangle, IsNotCrossedIfParallelToTheRay) {
  const V3 a{0, 0, 1};
  EXPECT_FALSE(crosses({0, 0, 0}, prepare_for_rays(a, a + ray_direction, a + 2.0 * ray_direction)));
}

TEST(RayCast, ColumnsAgreeWithTheDirectFormBitForBit) {
  std::mt19937 random(31);
  for (int pose = 0; pose < 2; ++pose) {
    const Cells cells = cells_of({posed(red_blood_cell(3, 9), testing::random_pose(random, {15, 14, 13}, 20))});
    for (const Lattice& lattice : {box, channel})
      EXPECT_EQ(differences(rays(cells, lattice, RaySearch::columns), rays(cells, lattice, RaySearch::direct),
                            whole(lattice)),
                0);
  }
}

TEST(RayCast, ColumnsAgreeWithTheDirectFormOnACrumpledCell) {
  std::mt19937 random(32);
  for (int pose = 0; pose < 2; ++pose) {
    const Cells cells =
        cells_of({posed(crumpled(red_blood_cell(3, 8)), testing::random_pose(random, {15, 14, 13}, 10))});
    const Flags direct = rays(cells, box, RaySearch::direct);
    EXPECT_EQ(differences(rays(cells, box, RaySearch::columns), direct, whole(box)), 0);
    EXPECT_GT(count_inside(direct), 300);
  }
}

TEST(RayCast, ColumnsAgreeWithTheDirectFormOnACoarseMesh) {
  const Cells cells =
      cells_of({posed(sphere(0, 11), {{1, 2, 3}, 0.5, {15.1, 14.2, 13.3}})});  // 20 triangles of 12 nodes
  EXPECT_EQ(differences(rays(cells, box, RaySearch::columns), rays(cells, box, RaySearch::direct), whole(box)), 0);
}

TEST(RayCast, FindsTheInsideOfASphere) {
  const double radius = 9;
  const Vec3 centre(15.3, 13.8, 12.6);
  const Cells cells = cells_of({posed(sphere(4, radius), {{0, 0, 1}, 0, centre})});
  const Flags flags = rays(cells, box, RaySearch::columns);
  testing::for_each_node(whole(box), 0, [&](int i, int j, int k) {
    const double r = (Vec3(i, j, k) - centre).norm();
    // The chords of 2562 vertices run at most h^2 / (8 R) = 0.01 below the sphere.
    if (r < radius - 0.02 || r > radius) {
      ASSERT_EQ(flags(i, j, k), r < radius) << r;
    }
  });
}

TEST(RayCast, DoesNotSeeThePeriodicBorder) {
  const testing::Pose pose{{1, 1, 0}, 1.1, {15.25, 14.75, 13.5}};  // shifts below are exact in binary
  Surface moved = posed(red_blood_cell(3, 9), pose);
  const Flags middle = rays(cells_of({moved}), box, RaySearch::columns);
  const Int3 shift{14, -13, 12};
  translate(moved, Vec3(shift[0] + 2 * box.size[0], shift[1], shift[2] - box.size[2]));
  const Flags across = rays(cells_of({moved}), box, RaySearch::columns);
  std::int64_t wrong = 0;
  testing::for_each_node(whole(box), 0, [&](int i, int j, int k) {
    wrong += middle(i, j, k) != across(box.wrap(0, i + shift[0]), box.wrap(1, j + shift[1]), box.wrap(2, k + shift[2]));
  });
  EXPECT_EQ(wrong, 0);
}

TEST(RayCast, UnitesOverlappingCells) {
  const Surface a = posed(sphere(3, 6), {{0, 0, 1}, 0, {12.3, 13.4, 12.5}});
  const Surface b = posed(sphere(3, 6), {{0, 0, 1}, 0, {16.1, 13.4, 12.5}});
  for (const RaySearch search : {RaySearch::direct, RaySearch::columns}) {
    const Flags first = rays(cells_of({a}), box, search), second = rays(cells_of({b}), box, search);
    const Flags both = rays(cells_of({a, b}), box, search);
    testing::for_each_node(whole(box), 0,
                           [&](int i, int j, int k) { ASSERT_EQ(both(i, j, k), first(i, j, k) | second(i, j, k)); });
  }
}

TEST(RayCast, IsTheSameOnAnyCut) {
  const Cells cells = cells_of({posed(red_blood_cell(2, 9), {{1, 2, -1}, 0.8, {29.2, 14.7, 1.4}})});
  const Flags one = rays(cells, box, RaySearch::columns);
  for (const Int3& parts : cuts())
    for (const Block& block : cut(box, parts))
      for (const RaySearch search : {RaySearch::direct, RaySearch::columns}) {
        Flags part = flags_on(block);
        cast_rays(cells, box, block, search, part);
        EXPECT_EQ(differences_on_block(part, one, block), 0);
      }
}

TEST(RayCast, NearTheMembraneRepairsTheShellAndNothingElse) {
  const Cells cells = cells_of({posed(red_blood_cell(4, 9), {{1, 2, -1}, 0.8, {29.2, 14.7, 13.4}})});
  const Flags truth = rays(cells, box, RaySearch::columns);
  for (const RaySearch search : {RaySearch::direct, RaySearch::columns}) {
    Flags flags = flags_on(whole(box));
    testing::for_each_node(whole(box), 0, [&](int i, int j, int k) { flags(i, j, k) = !truth(i, j, k); });
    cast_rays_near_membrane(cells, box, whole(box), search, flags);
    const std::int64_t wrong = differences(flags, truth, whole(box));
    EXPECT_EQ(wrong, box.nodes() - testing::shell_nodes(cells, box));
  }
}

TEST(RayCast, RefusesPositionsOutOfThisWorld) {
  for (const double bad : {1e9, std::numeric_limits<double>::quiet_NaN()}) {
    Cells cells = cells_of({posed(sphere(2, 5), {{0, 0, 1}, 0, {15, 14, 13}})});
    cells.X.y[7] = bad;
    Flags flags = flags_on(whole(box));
    EXPECT_THROW(cast_rays(cells, box, whole(box), RaySearch::columns, flags), Error);
  }
}

}  // namespace
}  // namespace rouleau
