// SPDX-License-Identifier: BSD-3-Clause
// A vector of three plain doubles for the laws of one triangle, and views that load it from structures of arrays.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/vec3.hpp"

namespace rouleau {

/// Plain members instead of an Eigen type: inside `omp simd` loops the compiler keeps them as vector registers.
struct V3 {
  double x = 0, y = 0, z = 0;
};

constexpr V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr V3 operator-(V3 a) { return {-a.x, -a.y, -a.z}; }
constexpr V3 operator*(double s, V3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr V3 cross(V3 a, V3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// s a + b with one rounding. For forces; predicates such as ray casting need the symmetry that fusing loses.
inline V3 fused(double s, V3 a, V3 b) { return {std::fma(s, a.x, b.x), std::fma(s, a.y, b.y), std::fma(s, a.z, b.z)}; }
inline double fused_dot(V3 a, V3 b) { return std::fma(a.x, b.x, std::fma(a.y, b.y, a.z * b.z)); }

/// Read access to a VectorArray by index.
struct ConstV3s {
  const double *x, *y, *z;
  explicit ConstV3s(const VectorArray& v) : x(v.x.data()), y(v.y.data()), z(v.z.data()) {}
  template <class Index>
  V3 operator[](Index i) const {
    return {x[i], y[i], z[i]};
  }
};

/// Write access to a VectorArray by index.
struct V3s {
  double *x, *y, *z;
  explicit V3s(VectorArray& v) : x(v.x.data()), y(v.y.data()), z(v.z.data()) {}
  void set(std::size_t i, V3 value) const {
    x[i] = value.x;
    y[i] = value.y;
    z[i] = value.z;
  }
};

inline Vec3 to_vec3(V3 a) { return {a.x, a.y, a.z}; }
inline V3 to_v3(const Vec3& a) { return {a[0], a[1], a[2]}; }

}  // namespace rouleau
