// SPDX-License-Identifier: BSD-3-Clause
#include "sphere_mesh.hpp"

#include <cmath>
#include <map>
#include <vector>

#include "membrane/check_surface.hpp"
#include "membrane/order.hpp"
#include "membrane/shape_equations.hpp"
#include "membrane/shapes.hpp"

namespace rouleau::speed {

namespace {

/// Points of the unit sphere, each once, although the faces that share an edge compute it with other roundings.
class Points {
 public:
  std::int32_t add(const Vec3& on_face) {
    const Vec3 point = on_face.normalized();
    constexpr double cells_per_length = 1e6;
    std::array<long, 3> key{};
    for (int axis = 0; axis < 3; ++axis) key[axis] = std::lround(point[axis] * cells_per_length);
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::int32_t>(points_.size()));
    if (is_new) points_.push_back(point);
    return found->second;
  }
  [[nodiscard]] const std::vector<Vec3>& all() const { return points_; }

 private:
  std::map<std::array<long, 3>, std::int32_t> numbers_;
  std::vector<Vec3> points_;
};

}  // namespace

Surface red_blood_cell_of_frequency(int frequency, double radius, const Vec3& centre) {
  const Surface icosahedron = unit_sphere(0);
  Points points;
  Surface surface;
  const auto add_triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    surface.triangles.a.push_back(a);
    surface.triangles.b.push_back(b);
    surface.triangles.c.push_back(c);
  };
  for (std::size_t t = 0; t < icosahedron.triangles.size(); ++t) {
    const auto corner = [&](const auto& index) { return at(icosahedron.X, static_cast<std::size_t>(index[t])); };
    const Vec3 a = corner(icosahedron.triangles.a), b = corner(icosahedron.triangles.b),
               c = corner(icosahedron.triangles.c);
    const auto point = [&](int i, int j) { return points.add((frequency - i - j) * a + i * b + j * c); };
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; i + j < frequency; ++j) {
        add_triangle(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j + 1 < frequency) add_triangle(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
  }
  surface.X.resize(points.all().size());
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    const Vec3& on_sphere = points.all()[v];
    const double r2 = on_sphere[0] * on_sphere[0] + on_sphere[1] * on_sphere[1];
    const double z = 0.5 * red_blood_cell_profile(r2) * on_sphere[2];
    set(surface.X, v, centre + radius * Vec3(on_sphere[0], on_sphere[1], z));
  }
  check_surface(surface, "benchmark mesh");
  return reordered(surface, space_curve_order(surface));
}

}  // namespace rouleau::speed
