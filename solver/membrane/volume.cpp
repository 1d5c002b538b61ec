// SPDX-License-Identifier: BSD-3-Clause
// Volume and area of a cell, and the shift of its vertices that restores the volume.
#include "membrane/volume.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "membrane/ordered_sum.hpp"
#include "membrane/v3.hpp"

namespace rouleau {
namespace {

/// |V/V0 - 1| at which a volume counts as restored: a hundred times the round-off of the sum, a tenth of the promise.
constexpr double volume_tolerance = 1e-13;

/// The corners of a cell's triangles relative to its first vertex, so that sums do not grow with the distance to the
/// origin.
struct Corners {
  const std::int32_t *a, *b, *c;
  ConstV3s X;
  V3 origin;
  Corners(const Triangles& triangles, const VectorArray& positions, const CellRange& range)
      : a(triangles.a.data()),
        b(triangles.b.data()),
        c(triangles.c.data()),
        X(positions),
        origin(X[range.vertex_begin]) {}
  [[nodiscard]] V3 at_a(std::ptrdiff_t t) const { return X[a[t]] - origin; }
  [[nodiscard]] V3 at_b(std::ptrdiff_t t) const { return X[b[t]] - origin; }
  [[nodiscard]] V3 at_c(std::ptrdiff_t t) const { return X[c[t]] - origin; }
};

double triple(V3 a, V3 b, V3 c) { return dot(a, cross(b, c)); }

CellRange whole(const Surface& surface) {
  CellRange range;
  range.vertex_end = static_cast<std::int32_t>(surface.X.size());
  range.triangle_end = static_cast<std::int32_t>(surface.triangles.size());
  return range;
}

}  // namespace

double volume(const Triangles& triangles, const VectorArray& X, const CellRange& range) {
  const Corners corners(triangles, X, range);
  return ordered_sum(range.triangle_begin, range.triangle_end,
                     [&](std::ptrdiff_t t) { return triple(corners.at_a(t), corners.at_b(t), corners.at_c(t)); }) /
         6;
}

double area(const Triangles& triangles, const VectorArray& X, const CellRange& range) {
  const Corners corners(triangles, X, range);
  return ordered_sum(range.triangle_begin, range.triangle_end,
                     [&](std::ptrdiff_t t) {
                       const V3 a = corners.at_a(t);
                       const V3 N = cross(corners.at_b(t) - a, corners.at_c(t) - a);
                       return std::sqrt(dot(N, N));
                     }) /
         2;
}

double volume(const Cells& cells, std::size_t cell) { return volume(cells.triangles, cells.X, cells.ranges[cell]); }
double area(const Cells& cells, std::size_t cell) { return area(cells.triangles, cells.X, cells.ranges[cell]); }
double volume(const Surface& surface) { return volume(surface.triangles, surface.X, whole(surface)); }
double area(const Surface& surface) { return area(surface.triangles, surface.X, whole(surface)); }

VolumeShift::VolumeShift(const Cells& cells)
    : gather_(cells.around, 0, static_cast<std::int32_t>(cells.triangles.size())),
      normal_(cells.triangles.size() + 1),
      gradient_(static_cast<std::size_t>(gather_.blocks()) * VertexGather::width) {}

double VolumeShift::restore(Cells& cells) {
  double largest = 0;
  for (std::size_t cell = 0; cell < cells.ranges.size(); ++cell) {
    largest = std::max(largest, restore_cell(cells, cell));
  }
  return largest;
}

double VolumeShift::restore_cell(Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const Corners corners(cells.triangles, cells.X, range);
  const V3s normal(normal_);
  const double V = ordered_sum(range.triangle_begin, range.triangle_end,
                               [&](std::ptrdiff_t t) {
                                 const V3 a = corners.at_a(t), b = corners.at_b(t), c = corners.at_c(t);
                                 normal.set(static_cast<std::size_t>(t), cross(b - a, c - a));
                                 return triple(a, b, c);
                               }) /
                   6;
  const double error = V / range.volume_0 - 1;
  if (!(std::abs(error) <= largest_volume_error)) {
    fail(Exit::physics,
         "cell {}: its volume is {} of the wanted one; at most {} off can be restored. Try a smaller time step.", cell,
         V / range.volume_0, largest_volume_error);
  }

  // dV/dX of a vertex of a closed mesh: a sixth of the sum of u x v over its triangles.
  constexpr std::int32_t width = VertexGather::width;
  const V3s gradient(gradient_);
  for (std::int32_t block = range.vertex_begin / width; block * width < range.vertex_end; ++block) {
    const auto sums = gather_.sum<3>(block, {normal_.x.data(), normal_.y.data(), normal_.z.data()});
    const std::ptrdiff_t first = std::ptrdiff_t{block} * width;
#pragma omp simd
    for (std::int32_t l = 0; l < width; ++l) {
      gradient.x[first + l] = sums[0][l] / 6;
      gradient.y[first + l] = sums[1][l] / 6;
      gradient.z[first + l] = sums[2][l] / 6;
    }
  }

  // V(X + m d) is a cubic in m with the slope d.d at m = 0. Corrections by this slope shrink the error by about itself
  // each time: a leak of one step is gone after one.
  const ConstV3s d(gradient_);
  const double slope =
      ordered_sum(range.vertex_begin, range.vertex_end, [&](std::ptrdiff_t v) { return dot(d[v], d[v]); });
  const V3s X(cells.X);
  constexpr int most_corrections = 40;
  for (int i = 0; i < most_corrections; ++i) {
    const double missing = range.volume_0 - (i == 0 ? V : volume(cells, cell));
    if (std::abs(missing) <= volume_tolerance * range.volume_0) return std::abs(error);
    const double m = missing / slope;
#pragma omp simd
    for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
      X.x[v] += m * d.x[v];
      X.y[v] += m * d.y[v];
      X.z[v] += m * d.z[v];
    }
  }
  fail(Exit::physics,
       "cell {}: its volume could not be restored from {} of the wanted one; the mesh has lost its shape.", cell,
       V / range.volume_0);
}

}  // namespace rouleau
