// SPDX-License-Identifier: BSD-3-Clause
// Numbering a loaded mesh along a space-filling curve, so that neighbours stand close in memory.
#include "membrane/order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace rouleau {
namespace {

constexpr int bits_per_axis = 20;

/// Interleaves the bits of three grid coordinates.
std::uint64_t z_order_key(const Vec3& fraction) {
  std::uint64_t key = 0;
  std::array<std::uint64_t, 3> cell{};
  constexpr double cells = std::uint64_t{1} << bits_per_axis;
  for (int axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::uint64_t>(std::clamp(std::floor(fraction[axis] * cells), 0.0, cells - 1));
  }
  for (int bit = bits_per_axis - 1; bit >= 0; --bit) {
    for (int axis = 0; axis < 3; ++axis) key = (key << 1) | ((cell[axis] >> bit) & 1);
  }
  return key;
}

}  // namespace

MeshOrder space_curve_order(const Surface& surface) {
  const Triangles& triangles = surface.triangles;
  Vec3 low = at(surface.X, 0), high = low;
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    low = low.cwiseMin(at(surface.X, v));
    high = high.cwiseMax(at(surface.X, v));
  }
  const double size = (high - low).maxCoeff();  // one scale for all axes: the curve follows the shape, not its box
  std::vector<std::pair<std::uint64_t, std::int32_t>> keys;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3 centre =
        (at(surface.X, triangles.a[t]) + at(surface.X, triangles.b[t]) + at(surface.X, triangles.c[t])) / 3;
    keys.emplace_back(z_order_key((centre - low) / size), static_cast<std::int32_t>(t));
  }
  std::sort(keys.begin(), keys.end());

  MeshOrder order;
  std::vector<bool> used(surface.X.size(), false);
  for (const auto& [key, t] : keys) {
    order.triangle.push_back(t);
    for (const std::int32_t v : {triangles.a[t], triangles.b[t], triangles.c[t]}) {
      if (used[v]) continue;
      used[v] = true;
      order.vertex.push_back(v);
    }
  }
  return order;
}

Surface reordered(const Surface& surface, const MeshOrder& order) {
  Surface result;
  result.X.resize(order.vertex.size());
  std::vector<std::int32_t> number(surface.X.size());
  for (std::size_t v = 0; v < order.vertex.size(); ++v) {
    set(result.X, v, at(surface.X, order.vertex[v]));
    number[order.vertex[v]] = static_cast<std::int32_t>(v);
  }
  for (const std::int32_t t : order.triangle) {
    result.triangles.a.push_back(number[surface.triangles.a[t]]);
    result.triangles.b.push_back(number[surface.triangles.b[t]]);
    result.triangles.c.push_back(number[surface.triangles.c[t]]);
  }
  return result;
}

}  // namespace rouleau
