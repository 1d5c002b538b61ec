// SPDX-License-Identifier: BSD-3-Clause
// Flags from the equations of the shapes.
#include "interior/analytic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "interior/ray_cast.hpp"
#include "meshes.hpp"

namespace rouleau {
namespace {

using testing::cells_of;
using testing::cut;
using testing::cuts;
using testing::differences;
using testing::differences_on_block;
using testing::flags_on;
using testing::Pose;
using testing::posed;
using testing::whole;

const Lattice box{{40, 36, 30}, {true, true, true}};

Body rotated_cell(const Pose& pose) {
  return {Body::Shape::red_blood_cell,
          {12, 12, 12},
          pose.centre,
          Eigen::AngleAxisd(pose.angle, pose.axis.normalized()).toRotationMatrix()};
}

Flags flags_of(const std::vector<Body>& bodies, const Lattice& lattice) {
  Flags flags = flags_on(whole(lattice));
  flag_bodies(bodies, lattice, whole(lattice), flags);
  return flags;
}

TEST(AnalyticFlags, OfAnEllipsoidFillItsVolume) {
  const Body body{Body::Shape::ellipsoid, {12.3, 9.1, 6.7}, {19.3, 17.9, 14.6}, Eigen::Matrix3d::Identity()};
  const double volume = 4.0 / 3.0 * std::numbers::pi * 12.3 * 9.1 * 6.7;
  // Nodes in a smooth body of radius R: the count is off by about R^1.5 of R^3.
  EXPECT_NEAR(static_cast<double>(count_inside(flags_of({body}, box))), volume, 30);
}

TEST(AnalyticFlags, OfARotatedRedBloodCellAgreeWithRaysThroughItsMesh) {
  const Pose pose{{1, 2, -1}, 0.8, {20.2, 17.7, 15.4}};
  const Cells mesh = cells_of({posed(red_blood_cell(6, 12), pose)});
  Flags rays = flags_on(whole(box));
  cast_rays(mesh, box, whole(box), RaySearch::columns, rays);
  const Flags analytic = flags_of({rotated_cell(pose)}, box);
  // The mesh of 81920 triangles runs up to 0.005 inside of the smooth surface of some 1260 node areas: about 3 nodes.
  EXPECT_LE(differences(analytic, rays, whole(box)), 8);
  EXPECT_GT(count_inside(analytic), 2600);  // V = 2718
}

TEST(AnalyticFlags, DoNotSeeThePeriodicBorder) {
  const Pose in_the_middle{{1, 1, 0}, 1.1, {20.25, 17.75, 15.5}};
  Pose across = in_the_middle;
  const Int3 shift{20, 18, -15};
  for (int axis = 0; axis < 3; ++axis) across.centre[axis] += shift[axis] - 2.0 * box.size[axis];
  const Flags a = flags_of({rotated_cell(in_the_middle)}, box), b = flags_of({rotated_cell(across)}, box);
  testing::for_each_node(whole(box), 0, [&](int i, int j, int k) {
    ASSERT_EQ(a(i, j, k), b(box.wrap(0, i + shift[0]), box.wrap(1, j + shift[1]), box.wrap(2, k + shift[2])));
  });
}

TEST(AnalyticFlags, UniteSeveralBodies) {
  const Body small{Body::Shape::ellipsoid, {5, 5, 5}, {12.5, 12.5, 12.5}, Eigen::Matrix3d::Identity()};
  Body overlapping = small;
  overlapping.centre[0] += 4;
  const Flags a = flags_of({small}, box), b = flags_of({overlapping}, box), both = flags_of({small, overlapping}, box);
  testing::for_each_node(whole(box), 0,
                         [&](int i, int j, int k) { ASSERT_EQ(both(i, j, k), a(i, j, k) | b(i, j, k)); });
}

TEST(AnalyticFlags, AreTheSameOnAnyCut) {
  const Body body = rotated_cell({{1, 2, -1}, 0.8, {39.2, 17.7, 1.4}});
  const Flags one = flags_of({body}, box);
  for (const Int3& parts : cuts())
    for (const Block& block : cut(box, parts)) {
      Flags part = flags_on(block);
      flag_bodies(std::span(&body, 1), box, block, part);
      EXPECT_EQ(differences_on_block(part, one, block), 0);
    }
}

TEST(AnalyticFlags, EndAtAWall) {
  const Lattice channel{{40, 36, 30}, {true, false, false}};
  const Body body{Body::Shape::ellipsoid, {6, 6, 6}, {20, -0.5, 15}, Eigen::Matrix3d::Identity()};
  const Flags flags = flags_of({body}, channel);
  EXPECT_EQ(flags(20, 0, 15), 1);
  EXPECT_EQ(flags(20, 35, 15), 0);
}

}  // namespace
}  // namespace rouleau
