// SPDX-License-Identifier: BSD-3-Clause
// Which triangles does a ray cross? [Moeller, Trumbore 1997], for rays that all have one direction.
#pragma once

#include <cstddef>
#include <cstdint>

#include "membrane/cells.hpp"
#include "membrane/v3.hpp"

namespace rouleau {

/// The paper's direction (Appendix A): one that hits no edge of a mesh except by an accident of rounding.
inline constexpr V3 ray_direction{0.01, 0.03, 1.04};

/// A triangle made ready for rays along `ray_direction`: what does not depend on the ray's origin.
struct RayTriangle {
  V3 corner, edge_1, edge_2;
  V3 p;            ///< direction x edge_2
  double inverse;  ///< 1 / (edge_1 . p); not finite for a triangle parallel to the ray, which is then never crossed
};

constexpr RayTriangle prepare_for_rays(V3 a, V3 b, V3 c) {
  const V3 edge_1 = b - a, edge_2 = c - a;
  const V3 p = cross(ray_direction, edge_2);
  return {a, edge_1, edge_2, p, 1.0 / dot(edge_1, p)};
}

/// Whether the half line from `origin` along `ray_direction` meets the triangle.
constexpr bool crosses(V3 origin, const RayTriangle& triangle) {
  const V3 s = origin - triangle.corner;
  const V3 q = cross(s, triangle.edge_1);
  const double u = triangle.inverse * dot(s, triangle.p);
  const double v = triangle.inverse * dot(ray_direction, q);
  const double t = triangle.inverse * dot(triangle.edge_2, q);
  return (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (t > 0.0);
}

/// Many of them, a component an array.
class RayTriangles {
 public:
  void resize(std::size_t n) {
    for (VectorArray* v : {&corner_, &edge_1_, &edge_2_, &p_}) v->resize(n);
    inverse_.resize(n);
  }
  void set(std::size_t slot, const RayTriangle& t) {
    V3s(corner_).set(slot, t.corner);
    V3s(edge_1_).set(slot, t.edge_1);
    V3s(edge_2_).set(slot, t.edge_2);
    V3s(p_).set(slot, t.p);
    inverse_[slot] = t.inverse;
  }
  /// Whether the ray from `origin` crosses an odd number of the triangles in slots [begin, end).
  [[nodiscard]] bool crosses_odd(V3 origin, std::int64_t begin, std::int64_t end) const {
    const ConstV3s corner(corner_), edge_1(edge_1_), edge_2(edge_2_), p(p_);
    const double* const inverse = inverse_.data();
    std::int64_t crossings = 0;
#pragma omp simd reduction(+ : crossings)
    for (std::int64_t t = begin; t < end; ++t)
      crossings += crosses(origin, RayTriangle{corner[t], edge_1[t], edge_2[t], p[t], inverse[t]});
    return crossings % 2 != 0;
  }

 private:
  VectorArray corner_, edge_1_, edge_2_, p_;
  Array<double> inverse_;
};

}  // namespace rouleau
