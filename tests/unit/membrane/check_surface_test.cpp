// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with one defect each.
#include "membrane/check_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"

namespace rouleau {
namespace {

using testing::HasSubstr;

void add_triangle(Surface& s, int a, int b, int c) {
  s.triangles.a.push_back(a);
  s.triangles.b.push_back(b);
  s.triangles.c.push_back(c);
}

void add_vertex(Surface& s, const Vec3& x) {
  s.X.resize(s.X.size() + 1);
  set(s.X, s.X.size() - 1, x);
}

void remove_last_triangle(Surface& s) {
  s.triangles.a.pop_back();
  s.triangles.b.pop_back();
  s.triangles.c.pop_back();
}

/// Appends `other`, its vertex `shared` being vertex 0 of `s` if not negative.
void append(Surface& s, const Surface& other, int shared) {
  std::vector<int> number;
  for (std::size_t v = 0; v < other.X.size(); ++v) {
    if (static_cast<int>(v) == shared) {
      number.push_back(0);
      continue;
    }
    number.push_back(static_cast<int>(s.X.size()));
    add_vertex(s, at(other.X, v));
  }
  for (std::size_t t = 0; t < other.triangles.size(); ++t) {
    add_triangle(s, number[other.triangles.a[t]], number[other.triangles.b[t]], number[other.triangles.c[t]]);
  }
}

Surface shifted_sphere(const Vec3& shift) {
  Surface s = unit_sphere(1);
  translate(s, shift);
  return s;
}

struct Defect {
  const char* name;
  std::function<void(Surface&)> plant;
  const char* message;
};

class MembraneDefects : public testing::TestWithParam<Defect> {};
TEST_P(MembraneDefects, AreNamed) {
  Surface s = unit_sphere(1);  // 80 triangles, 42 vertices
  GetParam().plant(s);
  try {
    check_surface(s, "cell.off");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
    EXPECT_THAT(error.what(), HasSubstr("cell.off: "));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Membrane, MembraneDefects,
    testing::Values(
        Defect{"Empty", [](Surface& s) { s = {}; }, "0 triangles; a closed surface has at least 4"},
        Defect{"Hole", [](Surface& s) { remove_last_triangle(s); }, "alone; the surface is not closed"},
        Defect{"IndexTooLarge", [](Surface& s) { s.triangles.b[3] = 42; }, "triangle 3 names vertex 42; there are 42"},
        Defect{"IndexNegative", [](Surface& s) { s.triangles.b[3] = -1; }, "triangle 3 names vertex -1"},
        Defect{"VertexTwice", [](Surface& s) { s.triangles.b[3] = s.triangles.a[3]; }, "names a vertex twice"},
        Defect{"NotFinite", [](Surface& s) { s.X.z[7] = std::nan(""); }, "vertex 7 is not finite"},
        Defect{"DuplicateVertex", [](Surface& s) { set(s.X, 20, at(s.X, 4)); }, "vertices 4 and 20 are both at"},
        Defect{"UnusedVertex",
               [](Surface& s) {
                 add_vertex(s, {5, 5, 5});
               },
               "vertex 42 belongs to no triangle"},
        Defect{"Needle",
               [](Surface& s) {
                 const Vec3 b = at(s.X, s.triangles.b[9]), c = at(s.X, s.triangles.c[9]);
                 set(s.X, s.triangles.a[9], 0.5 * (b + c) + Vec3(1e-12, 0, 0));
               },
               "is degenerate"},
        Defect{"TurnedTriangle", [](Surface& s) { std::swap(s.triangles.a[5], s.triangles.b[5]); },
               "in the same direction; one of them is turned inside out"},
        Defect{"ThirdTriangleOnAnEdge",
               [](Surface& s) {
                 add_vertex(s, {3, 3, 3});
                 add_triangle(s, s.triangles.a[0], s.triangles.b[0], 42);
               },
               "belongs to 3 triangles"},
        Defect{"TwoParts",
               [](Surface& s) {
                 append(s, shifted_sphere({5, 0, 0}), -1);
               },
               "triangle 80 is not connected to triangle 0"},
        Defect{"InwardNormals", [](Surface& s) { std::swap(s.triangles.a, s.triangles.b); }, "normals inwards"}),
    [](const auto& defect) { return defect.param.name; });

TEST(MembraneCheckSurface, NamesAVertexInWhichASurfaceTouchesItself) {
  // Two vertices of one sphere, drawn together into one: still connected, but the fans do not meet across an edge.
  Surface s = unit_sphere(2);
  std::size_t far = 0;
  for (std::size_t v = 0; v < s.X.size(); ++v) {
    if ((at(s.X, v) + at(s.X, 0)).norm() < 1e-12) far = v;
  }
  ASSERT_NE(far, 0u);
  const std::size_t last = s.X.size() - 1;
  for (auto* corner : {&s.triangles.a, &s.triangles.b, &s.triangles.c}) {
    for (std::int32_t& v : *corner) {
      if (v == static_cast<std::int32_t>(far)) {
        v = 0;
      } else if (v == static_cast<std::int32_t>(last)) {
        v = static_cast<std::int32_t>(far);
      }
    }
  }
  set(s.X, far, at(s.X, last));
  s.X.resize(last);
  set(s.X, 0, Vec3(0.01, 0.02, 0.03));
  try {
    check_surface(s, "cell.off");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("touch in vertex 0 without a fan between them"));
  }
}

TEST(MembraneCheckSurface, AcceptsATetrahedron) {
  Surface s;
  s.X.x = {0, 1, 0, 0};
  s.X.y = {0, 0, 1, 0};
  s.X.z = {0, 0, 0, 1};
  s.triangles.a = {0, 0, 0, 1};
  s.triangles.b = {2, 1, 3, 2};
  s.triangles.c = {1, 3, 2, 3};
  EXPECT_NO_THROW(check_surface(s, "tetrahedron"));
}

}  // namespace
}  // namespace rouleau
