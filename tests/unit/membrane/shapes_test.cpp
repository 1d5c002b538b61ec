// SPDX-License-Identifier: BSD-3-Clause
// Generated shapes and transforms, against the analytic shapes and the digits of Evans and Fung.
#include "membrane/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "membrane/check_surface.hpp"
#include "membrane/edges.hpp"
#include "membrane/shape_equations.hpp"
#include "membrane/transform.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

TEST(MembraneShapes, EveryLevelHasTheCountsOfEulerAndIsAClosedSurface) {
  for (int n = 0; n <= 5; ++n) {
    const Surface surface = unit_sphere(n);
    const std::size_t splits = std::size_t{1} << (2 * n);
    EXPECT_EQ(surface.triangles.size(), 20 * splits);
    EXPECT_EQ(surface.X.size(), 10 * splits + 2);
    EXPECT_NO_THROW(check_surface(surface, "sphere"));
    EXPECT_NO_THROW(check_surface(red_blood_cell(n, 4), "red blood cell"));
  }
}

TEST(MembraneShapes, EveryFrequencyHasTheCountsOfEulerAndIsAClosedSurface) {
  for (const int n : {1, 3, 5, 6, 9, 12, 14, 24}) {
    const Surface surface = unit_sphere(Division::of_frequency(n));
    EXPECT_EQ(surface.triangles.size(), static_cast<std::size_t>(20 * n * n));
    EXPECT_EQ(surface.X.size(), static_cast<std::size_t>(10 * n * n + 2));  // V - E + F = 2 with E = 3/2 F
    EXPECT_NO_THROW(check_surface(surface, "sphere"));
    EXPECT_NO_THROW(check_surface(red_blood_cell(Division::of_frequency(n), 4), "red blood cell"));
  }
}

TEST(MembraneShapes, AFrequencyOfAPowerOfTwoIsASubdivisionToTheBit) {
  const Surface by_frequency = unit_sphere(Division::of_frequency(8)), by_subdivisions = unit_sphere(3);
  EXPECT_EQ(by_frequency.X.x, by_subdivisions.X.x);
  EXPECT_EQ(by_frequency.X.y, by_subdivisions.X.y);
  EXPECT_EQ(by_frequency.X.z, by_subdivisions.X.z);
  EXPECT_EQ(by_frequency.triangles.a, by_subdivisions.triangles.a);
}

TEST(MembraneShapes, EdgesOfAnyFrequencyAreAboutEquallyLong) {
  for (const int n : {4, 8, 16}) {  // the measure: what subdivision alone gives
    const EdgeLengths split = edge_lengths(unit_sphere(Division::of_frequency(n)));
    const EdgeLengths cut = edge_lengths(unit_sphere(Division::of_frequency(3 * n / 2)));
    EXPECT_LT(cut.max / cut.min, 1.1 * split.max / split.min);
    EXPECT_NEAR(cut.mean / split.mean, 2.0 / 3.0, 0.02);
  }
}

TEST(MembraneShapes, VolumeAndAreaConvergeAtSecondOrderInTheFrequency) {
  const double exact_volume = 4 * std::numbers::pi / 3, exact_area = 4 * std::numbers::pi;
  const Surface coarse = unit_sphere(Division::of_frequency(6)), fine = unit_sphere(Division::of_frequency(12));
  EXPECT_NEAR((1 - volume(coarse) / exact_volume) / (1 - volume(fine) / exact_volume), 4, 0.2);
  EXPECT_NEAR((1 - area(coarse) / exact_area) / (1 - area(fine) / exact_area), 4, 0.2);
}

TEST(MembraneShapes, SphereVolumeAndAreaConvergeAtSecondOrder) {
  const double exact_volume = 4 * std::numbers::pi / 3 * 8, exact_area = 4 * std::numbers::pi * 4;
  double volume_error = 0, area_error = 0;
  for (int n = 2; n <= 5; ++n) {
    const Surface surface = sphere(n, 2);
    const double new_volume_error = 1 - volume(surface) / exact_volume, new_area_error = 1 - area(surface) / exact_area;
    EXPECT_GT(new_volume_error, 0);  // the mesh is inscribed
    if (n > 2) {
      EXPECT_NEAR(volume_error / new_volume_error, 4, 0.2);  // second order in the edge length
      EXPECT_NEAR(area_error / new_area_error, 4, 0.2);
    }
    volume_error = new_volume_error;
    area_error = new_area_error;
  }
}

struct EvansFung {
  int subdivisions;
  double volume, area;
};

// Computed independently, R = 4; tolerance: half of the last digit given.
class RedBloodCellDigits : public testing::TestWithParam<EvansFung> {};
TEST_P(RedBloodCellDigits, VolumeAndAreaAreThoseOfEquation15) {
  const Surface surface = red_blood_cell(GetParam().subdivisions, 4);
  EXPECT_NEAR(volume(surface), GetParam().volume, 5e-5);
  EXPECT_NEAR(area(surface), GetParam().area, 5e-5);
}
INSTANTIATE_TEST_SUITE_P(Membrane, RedBloodCellDigits,
                         testing::Values(EvansFung{3, 99.7972, 139.4232}, EvansFung{4, 100.4471, 140.0807},
                                         EvansFung{5, 100.6105, 140.2461}));

TEST(MembraneShapes, RedBloodCellEdgesAreThoseOfThePaperMesh) {
  const EdgeLengths fine = edge_lengths(red_blood_cell(4, 4));
  EXPECT_NEAR(fine.mean, 0.2590, 5e-5);
  EXPECT_NEAR(fine.min, 0.1508, 5e-5);
  EXPECT_NEAR(fine.max, 0.3450, 5e-5);
  EXPECT_NEAR(edge_lengths(red_blood_cell(3, 4)).mean, 0.517, 5e-4);
}

TEST(MembraneShapes, RedBloodCellVerticesSatisfyEquation15) {
  const double R = 4;
  const Surface surface = red_blood_cell(3, R);
  int equator = 0;
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    const Vec3 x = at(surface.X, v);
    const double r2 = (x[0] * x[0] + x[1] * x[1]) / (R * R);
    const double bracket = 0.207 * R + 2.00 * R * r2 - 1.12 * R * r2 * r2;
    EXPECT_NEAR(x[2] * x[2], 0.25 * bracket * bracket * std::max(0.0, 1 - r2), 1e-14 * R * R);  // round-off
    EXPECT_TRUE(inside_red_blood_cell(0.999 * x, R) || r2 < 0.5);  // star-shaped outside the dimple
    EXPECT_FALSE(inside_red_blood_cell(x + Vec3(0, 0, x[2] > 0 ? 1e-6 : -1e-6), R) && x[2] != 0);
    if (x[2] == 0) ++equator;
  }
  EXPECT_GT(equator, 0);  // the equator's vertices stay in their plane exactly
}

TEST(MembraneShapes, PredicatesHoldAnalyticPoints) {
  EXPECT_TRUE(inside_sphere({0, 0, 2}, 2));
  EXPECT_FALSE(inside_sphere({0, 0.1, 2}, 2));
  EXPECT_TRUE(inside_ellipsoid({0, 2.9, 0}, {1, 3, 2}));
  EXPECT_FALSE(inside_ellipsoid({1.01, 0, 0}, {1, 3, 2}));
  EXPECT_TRUE(inside_red_blood_cell({0, 0, 0.413}, 4));  // half of the central thickness 0.828
  EXPECT_FALSE(inside_red_blood_cell({0, 0, 0.415}, 4));
  EXPECT_TRUE(inside_red_blood_cell({0, 2.801, 1.311}, 4));  // half of the largest thickness 2.622585 at r = 2.801
  EXPECT_FALSE(inside_red_blood_cell({0, 2.801, 1.3115}, 4));
  EXPECT_FALSE(inside_red_blood_cell({4.1, 0, 0}, 4));
}

TEST(MembraneShapes, EllipsoidHasItsSemiAxes) {
  const Vec3 semi_axes{1, 2, 3};
  const Surface surface = ellipsoid(5, semi_axes);
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    EXPECT_NEAR(at(surface.X, v).cwiseQuotient(semi_axes).norm(), 1, 1e-14);
  }
  EXPECT_NEAR(volume(surface) / (8 * std::numbers::pi), 1, 2e-3);  // second order: edge / radius is 0.03
}

TEST(MembraneShapes, NeighboursStandCloseInMemory) {
  const Surface surface = unit_sphere(4);
  double distance = 0;
  const auto count = static_cast<double>(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    distance += std::abs(surface.triangles.a[t] - surface.triangles.b[t]) / count;
  }
  EXPECT_LT(distance, 128);  // 2562 vertices in random order have a mean distance of 854
}

TEST(MembraneShapes, WrongSizesAreRefused) {
  EXPECT_THROW(unit_sphere(-1), Error);
  EXPECT_THROW(unit_sphere(8), Error);
  EXPECT_THROW(Division::of_frequency(0), Error);
  EXPECT_THROW(Division::of_frequency(129), Error);
  EXPECT_THROW(sphere(2, 0), Error);
  EXPECT_THROW(ellipsoid(2, {1, -1, 1}), Error);
  EXPECT_THROW(red_blood_cell(2, std::nan("")), Error);
}

TEST(MembraneTransform, RotatesRightHanded) {
  Surface surface = unit_sphere(0);
  set(surface.X, 0, {1, 0, 0});
  rotate(surface, {0, 0, 5}, std::numbers::pi / 2);
  EXPECT_LT((at(surface.X, 0) - Vec3(0, 1, 0)).norm(), 1e-15);
}

TEST(MembraneTransform, KeepsVolumeUnderRotationAndShiftAndScalesIt) {
  Surface surface = red_blood_cell(3, 4);
  const double before = volume(surface);
  rotate(surface, {1, 2, 3}, 0.7);
  translate(surface, {100, -7, 3});
  EXPECT_NEAR(volume(surface) / before, 1, 1e-13);  // round-off of coordinates near 100
  scale(surface, 2);
  EXPECT_NEAR(volume(surface) / before, 8, 1e-12);
}

TEST(MembraneTransform, WrongArgumentsAreRefused) {
  Surface surface = unit_sphere(0);
  EXPECT_THROW(scale(surface, 0), Error);
  EXPECT_THROW(rotate(surface, {0, 0, 0}, 1), Error);
  EXPECT_THROW(rotate(surface, {0, 0, 1}, std::nan("")), Error);
}

}  // namespace
}  // namespace rouleau
