// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of a cell: where it is, how it is stretched, how it lies.
#include "membrane/measures.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "membrane/ordered_sum.hpp"
#include "membrane/v3.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

/// Fixed-order sum of a vector a triangle.
template <class Term>
Vec3 sum_over_triangles(const CellRange& range, Term&& term) {
  return {ordered_sum(range.triangle_begin, range.triangle_end, [&](std::ptrdiff_t t) { return term(t).x; }),
          ordered_sum(range.triangle_begin, range.triangle_end, [&](std::ptrdiff_t t) { return term(t).y; }),
          ordered_sum(range.triangle_begin, range.triangle_end, [&](std::ptrdiff_t t) { return term(t).z; })};
}

}  // namespace

Vec3 vertex_mean(const VectorArray& values, const CellRange& range) {
  const auto mean = [&](const Array<double>& component) {
    return ordered_sum(range.vertex_begin, range.vertex_end, [&](std::ptrdiff_t v) { return component[v]; }) /
           (range.vertex_end - range.vertex_begin);
  };
  return {mean(values.x), mean(values.y), mean(values.z)};
}

// A triangle and an origin o span a tetrahedron of volume a . (b x c) / 6 with its centre at (a + b + c) / 4 from o;
// the signed sum over a closed mesh does not depend on o. The first vertex is taken, to keep the sums small.
Vec3 centre_of_mass(const Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const ConstV3s X(cells.X);
  const V3 origin = X[range.vertex_begin];
  const auto& [a, b, c] = cells.triangles;
  const Vec3 moment = sum_over_triangles(range, [&](std::ptrdiff_t t) {
    const V3 p = X[a[t]] - origin, q = X[b[t]] - origin, r = X[c[t]] - origin;
    return dot(p, cross(q, r)) * (p + q + r);
  });
  return to_vec3(origin) + moment / (24 * volume(cells, cell));
}

// d/dt of moment / (24 V) with the origin moving along: the product rule on both sums.
Vec3 centre_of_mass_velocity(const Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const ConstV3s X(cells.X), U(cells.U);
  const V3 origin = X[range.vertex_begin], drift = U[range.vertex_begin];
  const auto& [a, b, c] = cells.triangles;
  const auto volume_rate = [&](std::ptrdiff_t t) {
    const V3 p = X[a[t]] - origin, q = X[b[t]] - origin, r = X[c[t]] - origin;
    const V3 dp = U[a[t]] - drift, dq = U[b[t]] - drift, dr = U[c[t]] - drift;
    return dot(dp, cross(q, r)) + dot(dq, cross(r, p)) + dot(dr, cross(p, q));
  };
  const Vec3 moment_rate = sum_over_triangles(range, [&](std::ptrdiff_t t) {
    const V3 p = X[a[t]] - origin, q = X[b[t]] - origin, r = X[c[t]] - origin;
    const V3 dp = U[a[t]] - drift, dq = U[b[t]] - drift, dr = U[c[t]] - drift;
    return volume_rate(t) * (p + q + r) + dot(p, cross(q, r)) * (dp + dq + dr);
  });
  const double V = volume(cells, cell);
  const double rate = ordered_sum(range.triangle_begin, range.triangle_end, volume_rate) / 6;
  const Vec3 from_origin = centre_of_mass(cells, cell) - to_vec3(origin);
  return to_vec3(drift) + moment_rate / (24 * V) - rate / V * from_origin;
}

Eigen::Matrix3d gyration_tensor(const VectorArray& X, const CellRange& range) {
  const Vec3 mean = vertex_mean(X, range);
  const std::array<const double*, 3> x{X.x.data(), X.y.data(), X.z.data()};
  Eigen::Matrix3d S;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      S(i, j) = S(j, i) = ordered_sum(range.vertex_begin, range.vertex_end,
                                      [&](std::ptrdiff_t v) { return (x[i][v] - mean[i]) * (x[j][v] - mean[j]); }) /
                          (range.vertex_end - range.vertex_begin);
    }
  }
  return S;
}

double asphericity(const Eigen::Matrix3d& gyration) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gyration, Eigen::EigenvaluesOnly);
  const Vec3 l = solver.eigenvalues();
  const double Rg2 = l.sum();
  return (std::pow(l[0] - l[1], 2) + std::pow(l[1] - l[2], 2) + std::pow(l[2] - l[0], 2)) / (2 * Rg2 * Rg2);
}

double inclination_deg(const Eigen::Matrix3d& gyration) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gyration);
  const Vec3 axis = solver.eigenvectors().col(2);  // eigenvalues ascend
  // The axis has no sign: it is turned to point along +x.
  const double sign = axis[0] < 0 ? -1 : 1;
  return std::atan2(sign * axis[2], sign * axis[0]) * 180 / std::numbers::pi;
}

Vec3 extents(const VectorArray& X, const CellRange& range) {
  const auto extent = [&](const Array<double>& x) {
    const auto [low, high] = std::minmax_element(x.begin() + range.vertex_begin, x.begin() + range.vertex_end);
    return *high - *low;
  };
  return {extent(X.x), extent(X.y), extent(X.z)};
}

CellMeasures measure(const Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const Eigen::Matrix3d gyration = gyration_tensor(cells.X, range);
  CellMeasures m;
  m.centre_of_mass = centre_of_mass(cells, cell);
  m.velocity = centre_of_mass_velocity(cells, cell);
  m.vertex_mean = vertex_mean(cells.X, range);
  m.extents = extents(cells.X, range);
  m.volume = volume(cells, cell);
  m.area = area(cells, cell);
  m.volume_ratio = m.volume / range.volume_0;
  m.area_ratio = m.area / range.area_0;
  m.asphericity = asphericity(gyration);
  m.inclination_deg = inclination_deg(gyration);
  return m;
}

}  // namespace rouleau
