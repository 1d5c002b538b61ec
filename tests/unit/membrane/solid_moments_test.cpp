// SPDX-License-Identifier: BSD-3-Clause
// Second moments of bodies that have closed forms, and the markers of the membrane.
#include "membrane/solid_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "membrane/markers.hpp"
#include "membrane/transform.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

TEST(MembraneSolidMoments, OfACuboidAreExact) {
  // Integral of x^2 over a cuboid of side a, divided by its volume: a^2 / 12. Its faces need no refinement.
  Surface s;
  s.X.x = {0, 3, 3, 0, 0, 3, 3, 0};
  s.X.y = {0, 0, 2, 2, 0, 0, 2, 2};
  s.X.z = {0, 0, 0, 0, 1, 1, 1, 1};
  s.triangles.a = {0, 0, 4, 4, 0, 0, 2, 2, 1, 1, 0, 0};
  s.triangles.b = {2, 3, 5, 6, 1, 5, 3, 7, 2, 6, 4, 7};
  s.triangles.c = {1, 2, 6, 7, 5, 4, 7, 6, 6, 5, 7, 3};
  translate(s, {40, -7, 13});
  const Eigen::Matrix3d moments = solid_moments(one_cell(s), 0);
  const Eigen::Matrix3d expected = (Vec3(9, 4, 1) / 12).asDiagonal();
  EXPECT_LT((moments - expected).norm(), 1e-12);  // round-off of coordinates near 40
}

TEST(MembraneSolidMoments, OfAnEllipsoidConvergeWithTheMesh) {
  const Vec3 axes(3, 2, 1);
  double previous = 0;
  for (const int subdivisions : {2, 3, 4}) {
    const Eigen::Matrix3d moments = solid_moments(one_cell(ellipsoid(subdivisions, axes)), 0);
    const Eigen::Matrix3d exact = (axes.cwiseProduct(axes) / 5).asDiagonal();
    const double error = (moments - exact).norm() / exact.norm();
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 4, 0.3);  // second order in the edge
    }
    previous = error;
  }
}

TEST(MembraneSolidMoments, EllipseHasTheAxesAndTheAngleOfATiltedEllipsoid) {
  for (const double angle : {-80.0, -30.0, 0.0, 12.5, 45.0, 89.0}) {
    for (const int across : {1, 2}) {
      Surface s = ellipsoid(4, across == 2 ? Vec3(3, 1.5, 1) : Vec3(3, 1, 1.5));
      rotate(s, across == 2 ? Vec3(0, -1, 0) : Vec3(0, 0, 1), radians(angle));  // from x towards the other axis
      const PlaneEllipse ellipse = ellipse_in_plane(solid_moments(one_cell(s), 0), across);
      EXPECT_NEAR(ellipse.angle_deg, angle, 1e-9);
      EXPECT_NEAR(ellipse.deformation(), 0.5, 1e-12);  // the mesh shrinks both axes alike
      EXPECT_NEAR(ellipse.longer, 3, 0.01);            // of second order: 5120 triangles inside the ellipsoid
    }
  }
}

TEST(MembraneSolidMoments, IgnoreHowVerticesAreSpread) {
  // Vertices crowded to one side of a sphere leave it a sphere, as far as the coarse part resolves it.
  Surface s = sphere(5, 1);
  for (std::size_t v = 0; v < s.X.size(); ++v) {
    const Vec3 x = at(s.X, v);
    set(s.X, v, (x + Vec3(0.3, 0, 0.2)).normalized());
  }
  const PlaneEllipse ellipse = ellipse_in_plane(solid_moments(one_cell(s), 0), 2);
  EXPECT_LT(ellipse.deformation(), 1e-3);
}

TEST(MembraneMarkers, AreTheVerticesNearestToTheDirections) {
  Surface s = ellipsoid(3, {3, 2, 1});
  translate(s, {17, 4, 9});
  const Cells cells = one_cell(s);
  const Markers markers = choose_markers(cells, 0);
  const auto direction = [&](std::int32_t v) {
    return (at(cells.X, static_cast<std::size_t>(v)) - Vec3(17, 4, 9)).normalized();
  };
  EXPECT_GT(direction(markers.y)[1], std::cos(radians(6)));  // edges take about 8 degrees
  EXPECT_GT(direction(markers.z)[2], std::cos(radians(12)));
}

TEST(MembraneMarkers, OfTheSecondCellAreItsOwn) {
  Surface second = sphere(2, 3);
  translate(second, {20, 0, 0});
  const std::vector<CellStart> starts{{sphere(2, 3), std::nullopt}, {second, std::nullopt}};
  const Cells cells = assemble(starts);
  const Markers first = choose_markers(cells, 0), other = choose_markers(cells, 1);
  EXPECT_EQ(other.y, first.y + cells.ranges[1].vertex_begin);
  EXPECT_EQ(other.z, first.z + cells.ranges[1].vertex_begin);
}

}  // namespace
}  // namespace rouleau
