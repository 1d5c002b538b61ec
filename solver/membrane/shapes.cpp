// SPDX-License-Identifier: BSD-3-Clause
// Generated surfaces: subdivided icosahedra pressed into spheres, ellipsoids and red blood cells.
#include "membrane/shapes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "membrane/shape_equations.hpp"

namespace rouleau {
namespace {

/// Splits triangles depth first. A midpoint belongs to an edge, so both triangles of the edge get the same vertex.
class Subdivision {
 public:
  int add(const Vec3& point) {
    points_.push_back(point.normalized());
    return static_cast<int>(points_.size()) - 1;
  }

  void split(int a, int b, int c, int levels) {
    if (levels == 0) {
      triangles_.push_back({a, b, c});
      return;
    }
    const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    split(a, ab, ca, levels - 1);
    split(ab, b, bc, levels - 1);
    split(ab, bc, ca, levels - 1);
    split(ca, bc, c, levels - 1);
  }

  /// The surface with vertices in the order of their first use.
  [[nodiscard]] Surface surface() const {
    std::vector<int> number(points_.size(), -1);
    Surface result;
    result.X.resize(points_.size());
    int used = 0;
    const auto use = [&](int v) {
      if (number[v] < 0) {
        number[v] = used;
        set(result.X, static_cast<std::size_t>(used), points_[v]);
        ++used;
      }
      return number[v];
    };
    for (const auto& t : triangles_) {
      result.triangles.a.push_back(use(t[0]));
      result.triangles.b.push_back(use(t[1]));
      result.triangles.c.push_back(use(t[2]));
    }
    return result;
  }

 private:
  int midpoint(int a, int b) {
    const auto key = std::minmax(a, b);
    const auto [found, is_new] = midpoints_.try_emplace(std::pair<int, int>(key), 0);
    if (is_new) found->second = add(points_[a] + points_[b]);
    return found->second;
  }

  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;
  std::map<std::pair<int, int>, int> midpoints_;
};

void require_positive(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length)) {
    fail(Exit::bad_input, "shape: {} = {} must be positive and finite.", what, length);
  }
}

}  // namespace

Surface unit_sphere(int subdivisions) {
  if (subdivisions < min_subdivisions || subdivisions > max_subdivisions) {
    fail(Exit::bad_input, "shape: subdivisions = {} is outside {}..{}. 4 gives 5120 triangles.", subdivisions,
         min_subdivisions, max_subdivisions);
  }
  // The twelve corners of the icosahedron are those of three golden rectangles.
  const double g = std::numbers::phi;
  const std::array<Vec3, 12> corners{{{-1, g, 0},
                                      {1, g, 0},
                                      {-1, -g, 0},
                                      {1, -g, 0},
                                      {0, -1, g},
                                      {0, 1, g},
                                      {0, -1, -g},
                                      {0, 1, -g},
                                      {g, 0, -1},
                                      {g, 0, 1},
                                      {-g, 0, -1},
                                      {-g, 0, 1}}};
  // Each face shares an edge with one of the two before it.
  constexpr std::array<std::array<int, 3>, 20> faces{{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11},
                                                      {2, 11, 10}, {4, 11, 2}, {4, 5, 11}, {9, 5, 4},  {9, 1, 5},
                                                      {8, 1, 9},   {8, 7, 1},  {6, 7, 8},  {6, 10, 7}, {6, 2, 10},
                                                      {3, 2, 6},   {3, 4, 2},  {3, 9, 4},  {3, 8, 9},  {3, 6, 8}}};
  Subdivision subdivision;
  for (const Vec3& corner : corners) subdivision.add(corner);
  for (const auto& f : faces) subdivision.split(f[0], f[1], f[2], subdivisions);
  return subdivision.surface();
}

Surface sphere(int subdivisions, double radius) {
  require_positive(radius, "radius");
  return ellipsoid(subdivisions, Vec3::Constant(radius));
}

Surface ellipsoid(int subdivisions, const Vec3& semi_axes) {
  for (const double semi_axis : semi_axes) require_positive(semi_axis, "semi-axis");
  Surface surface = unit_sphere(subdivisions);
  for (std::size_t v = 0; v < surface.X.size(); ++v) set(surface.X, v, at(surface.X, v).cwiseProduct(semi_axes));
  return surface;
}

Surface red_blood_cell(int subdivisions, double radius) {
  require_positive(radius, "radius");
  Surface surface = unit_sphere(subdivisions);
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    const Vec3 on_sphere = at(surface.X, v);
    const double r2 = on_sphere[0] * on_sphere[0] + on_sphere[1] * on_sphere[1];
    // On the unit sphere sqrt(1 - r2) = |z|: this keeps the sign, and the equator stays where it is.
    const double z = 0.5 * red_blood_cell_profile(r2) * on_sphere[2];
    set(surface.X, v, radius * Vec3(on_sphere[0], on_sphere[1], z));
  }
  return surface;
}

}  // namespace rouleau
