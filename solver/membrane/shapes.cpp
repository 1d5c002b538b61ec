// SPDX-License-Identifier: BSD-3-Clause
// Generated surfaces: divided icosahedra pressed into spheres, ellipsoids and red blood cells.
#include "membrane/shapes.hpp"

#include <algorithm>
#include <array>
#include <bit>
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

/// Divides triangles depth first. A point on an edge belongs to the edge, so both of its triangles get the same vertex.
class Subdivision {
 public:
  int add(const Vec3& point) {
    points_.push_back(point.normalized());
    return static_cast<int>(points_.size()) - 1;
  }

  /// Cuts a triangle into parts x parts, and splits each of these `levels` times.
  void cut(int a, int b, int c, int parts, int levels) {
    std::vector<int> before{a}, row;  // parallel to bc, from a on
    for (int i = 1; i <= parts; ++i) {
      row.clear();
      for (int j = 0; j <= i; ++j) row.push_back(point_of_grid({a, b, c}, {parts - i, i - j, j}));
      for (int j = 0; j < i; ++j) {
        split(before[j], row[j], row[j + 1], levels);
        if (j + 1 < i) split(before[j], row[j + 1], before[j + 1], levels);
      }
      before.swap(row);
    }
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
  using Three = std::array<int, 3>;

  int midpoint(int a, int b) {
    const auto key = std::minmax(a, b);
    const auto [found, is_new] = midpoints_.try_emplace(std::pair<int, int>(key), 0);
    if (is_new) found->second = add(points_[a] + points_[b]);
    return found->second;
  }

  /// The vertex at the mean of the corners with these weights, which are whole numbers.
  int point_of_grid(const Three& corner, const Three& weight) {
    std::array<std::pair<int, int>, 3> key{};  // (corner, weight) in the order of the corners, the same for all faces
    for (std::size_t k = 0; k < 3; ++k) key[k] = {weight[k] > 0 ? corner[k] : -1, weight[k]};
    std::sort(key.begin(), key.end());
    if (key[1].first < 0) return key[2].first;
    const auto [found, is_new] = grid_points_.try_emplace(key, 0);
    if (is_new) {
      Vec3 sum = Vec3::Zero();
      for (const auto& [k, w] : key)
        if (w > 0) sum += w * points_[static_cast<std::size_t>(k)];
      found->second = add(sum);
    }
    return found->second;
  }

  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;
  std::map<std::pair<int, int>, int> midpoints_;
  std::map<std::array<std::pair<int, int>, 3>, int> grid_points_;
};

void require_positive(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length)) {
    fail(Exit::bad_input, "shape: {} = {} must be positive and finite.", what, length);
  }
}

}  // namespace

Division::Division(int subdivisions) : frequency_(0) {
  if (subdivisions < 0 || subdivisions > max_subdivisions) {
    fail(Exit::bad_input, "shape: subdivisions = {} is outside 0..{}. 4 gives 5120 triangles.", subdivisions,
         max_subdivisions);
  }
  frequency_ = 1 << subdivisions;
}

Division Division::of_frequency(int frequency) {
  constexpr int most = 1 << max_subdivisions;
  if (frequency < 1 || frequency > most) {
    fail(Exit::bad_input, "shape: frequency = {} is outside 1..{}. 16 gives 5120 triangles.", frequency, most);
  }
  Division division(0);
  division.frequency_ = frequency;
  return division;
}

Surface unit_sphere(Division division) {
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
  const int levels = std::countr_zero(static_cast<unsigned>(division.frequency()));
  for (const auto& f : faces) subdivision.cut(f[0], f[1], f[2], division.frequency() >> levels, levels);
  return subdivision.surface();
}

Surface sphere(Division division, double radius) {
  require_positive(radius, "radius");
  return ellipsoid(division, Vec3::Constant(radius));
}

Surface ellipsoid(Division division, const Vec3& semi_axes) {
  for (const double semi_axis : semi_axes) require_positive(semi_axis, "semi-axis");
  Surface surface = unit_sphere(division);
  for (std::size_t v = 0; v < surface.X.size(); ++v) set(surface.X, v, at(surface.X, v).cwiseProduct(semi_axes));
  return surface;
}

Surface red_blood_cell(Division division, double radius) {
  require_positive(radius, "radius");
  Surface surface = unit_sphere(division);
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
