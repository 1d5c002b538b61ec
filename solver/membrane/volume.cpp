// SPDX-License-Identifier: BSD-3-Clause
// Volume and area of a cell, and the shift of its vertices that restores the volume.
#include "membrane/volume.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "membrane/measures.hpp"
#include "membrane/ordered_sum.hpp"
#include "membrane/v3.hpp"

namespace rouleau {
namespace {

/// |V/V0 - 1| at which a volume counts as restored: a hundred times the round-off of the sum, a tenth of the promise.
constexpr double volume_tolerance = 1e-13;
/// A correction by the slope at the start leaves about `error` times what it corrects (of a sphere a third of that), so
/// when their product is this small there is no need to look again: even ten times that is within the tolerance.
constexpr double surely_restored = 1e-14;

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

VolumeShift::VolumeShift(const Cells& cells) : X_(cells.vertices()), gradient_(cells.vertices()) {}

double VolumeShift::restore(Cells& cells) {
  double largest = 0;
  for (std::size_t cell = 0; cell < cells.ranges.size(); ++cell) {
    largest = std::max(largest, restore_cell(cells, cell));
  }
  return largest;
}

double VolumeShift::restore_cell(Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  sum_gradients(cells, range);
  // V is a cubic form of X, so that X . dV/dX = 3 V; and V(X + m d) with d = dV/dX has the slope d . d at m = 0.
  Packed moment{}, square{};
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    moment += X_[v] * gradient_[v];
    square += gradient_[v] * gradient_[v];
  }
  const double V = (moment[0] + moment[1] + moment[2]) / 18, slope = (square[0] + square[1] + square[2]) / 36;
  const double error = V / range.volume_0 - 1;
  if (!(std::abs(error) <= largest_volume_error)) {
    fail(Exit::physics,
         "cell {} {}: its volume is {} of the wanted one; at most {} off can be restored. Try a smaller time step",
         cell, place_of(cells, cell), V / range.volume_0, largest_volume_error);
  }

  const V3s X(cells.X);
  constexpr int most_corrections = 40;
  double left = error;
  for (int i = 0; i < most_corrections && std::abs(left) > volume_tolerance; ++i) {
    const double m = -left * range.volume_0 / slope / 6;
    for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
      X.x[v] += m * gradient_[v][0];
      X.y[v] += m * gradient_[v][1];
      X.z[v] += m * gradient_[v][2];
    }
    left = std::abs(left * error) <= surely_restored ? 0 : volume(cells, cell) / range.volume_0 - 1;
  }
  if (!(std::abs(left) <= volume_tolerance)) {
    fail(Exit::physics,
         "cell {} {}: its volume could not be restored from {} of the wanted one; the mesh has lost its shape. Try a "
         "smaller time step",
         cell, place_of(cells, cell), V / range.volume_0);
  }
  return std::abs(error);
}

/// Sets 6 dV/dX of a closed mesh: of each vertex the sum of u x v over its triangles, in ascending order.
void VolumeShift::sum_gradients(const Cells& cells, const CellRange& range) {
  const Packed origin = packed(cells.X, range.vertex_begin);
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    X_[v] = packed(cells.X, v) - origin;
    gradient_[v] = Packed{};
  }
  const std::int32_t *a = cells.triangles.a.data(), *b = cells.triangles.b.data(), *c = cells.triangles.c.data();
  Packed* gradient = gradient_.data();
  for (std::int32_t t = range.triangle_begin; t < range.triangle_end; ++t) {
    const Packed X_a = X_[a[t]];
    const Packed normal = cross(X_[b[t]] - X_a, X_[c[t]] - X_a);
    gradient[a[t]] += normal;
    gradient[b[t]] += normal;
    gradient[c[t]] += normal;
  }
}

}  // namespace rouleau
