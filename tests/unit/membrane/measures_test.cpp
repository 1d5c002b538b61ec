// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of bodies whose measures are known.
#include "membrane/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "membrane/check_surface.hpp"
#include "membrane/transform.hpp"
#include "membrane/volume.hpp"
#include "sample_cells.hpp"

namespace rouleau {
namespace {

using test::one_cell;
using test::strongly_deformed;

double degrees(double d) { return d * std::numbers::pi / 180; }

TEST(MembraneMeasures, AsphericityOfTheRestingRedBloodCell) {
  const Cells cells = one_cell(red_blood_cell(4, 4));
  EXPECT_NEAR(measure(cells, 0).asphericity, 0.15137, 6e-6);  // computed independently
}

TEST(MembraneMeasures, AsphericityIsZeroForASphereAndOneForARod) {
  EXPECT_NEAR(measure(one_cell(sphere(3, 2)), 0).asphericity, 0, 1e-12);
  EXPECT_NEAR(asphericity(Vec3(0, 3, 0).asDiagonal()), 1, 1e-15);
  EXPECT_NEAR(asphericity(Vec3(2, 2, 0).asDiagonal()), 0.25, 1e-15);
}

TEST(MembraneMeasures, GyrationTensorTurnsWithTheCell) {
  Surface s = ellipsoid(3, {1, 2, 3});
  const Cells straight = one_cell(s);
  rotate(s, {1, 1, 0.3}, 0.8);
  translate(s, {40, -3, 7});
  const Cells turned = one_cell(s);
  EXPECT_NEAR(measure(turned, 0).asphericity, measure(straight, 0).asphericity, 1e-12);
  EXPECT_NEAR(gyration_tensor(turned.X, turned.ranges[0]).trace(),
              gyration_tensor(straight.X, straight.ranges[0]).trace(), 1e-11);
}

TEST(MembraneMeasures, CentreOfMassIgnoresHowVerticesAreSpread) {
  // A tetrahedron with three extra vertices on one face: the centre of its volume is still the mean of its four
  // corners.
  Surface s;
  s.X.x = {0, 3, 0, 0, 1.0, 1.5, 0.5};
  s.X.y = {0, 0, 2, 0, 0.5, 0.5, 1.0};
  s.X.z = {0, 0, 0, 1, 0, 0, 0};
  s.triangles.a = {0, 0, 1, 0, 1, 1, 5, 2, 0, 4};
  s.triangles.b = {1, 3, 2, 4, 4, 5, 6, 6, 6, 6};
  s.triangles.c = {3, 2, 3, 1, 5, 2, 2, 0, 4, 5};
  ASSERT_NO_THROW(check_surface(s, "tetrahedron"));
  translate(s, {10, 20, 30});
  const Cells cells = one_cell(s);
  const CellMeasures m = measure(cells, 0);
  EXPECT_NEAR(m.volume, 1, 1e-12);
  EXPECT_LT((m.centre_of_mass - Vec3(10.75, 20.5, 30.25)).norm(), 1e-12);
  EXPECT_GT((m.vertex_mean - m.centre_of_mass).norm(), 0.1);
}

TEST(MembraneMeasures, VelocityIsTheDerivativeOfTheCentre) {
  Cells cells = one_cell(strongly_deformed(red_blood_cell(3, 4), 0.02));
  const VectorArray X = cells.X;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const Vec3 x = at(X, v);
    set(cells.U, v, Vec3(2 + x[1] * x[2], 0.3 * x[0], std::sin(x[0]) - x[2]));
  }
  const Vec3 velocity = centre_of_mass_velocity(cells, 0);
  const double dt = 1e-5;
  const auto centre_after = [&](double time) {
    for (std::size_t v = 0; v < cells.vertices(); ++v) set(cells.X, v, at(X, v) + time * at(cells.U, v));
    return centre_of_mass(cells, 0);
  };
  const Vec3 difference = (centre_after(dt) - centre_after(-dt)) / (2 * dt);
  EXPECT_LT((difference - velocity).norm(), 1e-8);  // second order: dt^2 = 1e-10; round-off 1e-15 / dt
}

TEST(MembraneMeasures, InclinationIsTheAngleOfTheLongAxisToX) {
  for (const double angle : {-80.0, -30.0, 0.0, 12.5, 45.0, 89.0, 120.0}) {
    Surface s = ellipsoid(3, {3, 1, 1.5});
    rotate(s, {0, -1, 0}, degrees(angle));  // about -y: from x towards z
    const double expected = angle > 90 ? angle - 180 : angle;
    EXPECT_NEAR(measure(one_cell(s), 0).inclination_deg, expected, 1e-9);
  }
}

TEST(MembraneMeasures, ExtentsAndRatios) {
  Surface s = ellipsoid(4, {1, 2, 3});
  translate(s, {50, 5, 5});
  Cells cells = one_cell(s);
  cells.ranges[0].volume_0 *= 2;
  const CellMeasures m = measure(cells, 0);
  EXPECT_LT((m.extents - Vec3(2, 4, 6)).norm(), 1e-12);
  EXPECT_NEAR(m.volume_ratio, 0.5, 1e-14);
  EXPECT_NEAR(m.area_ratio, 1, 1e-14);
}

}  // namespace
}  // namespace rouleau
