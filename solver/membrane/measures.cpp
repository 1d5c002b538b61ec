// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of a cell: where it is, how it is stretched, how it lies.
#include "membrane/measures.hpp"

#include <fmt/format.h>

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

/// Of a cell about its first vertex: volume, the integral of the position over it, and their time derivatives when the
/// vertices move with cells.U.
struct VolumeMoments {
  V3 origin, drift;  ///< X and U of the first vertex
  double V = 0, V_rate = 0;
  V3 first, first_rate;
};

// A triangle and an origin o span a tetrahedron of volume a . (b x c) / 6 with its centre at (a + b + c) / 4 from o;
// the signed sum over a closed mesh does not depend on o. The first vertex is taken, to keep the sums small, and moves.
VolumeMoments volume_moments(const Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const ConstV3s X(cells.X), U(cells.U);
  VolumeMoments m;
  m.origin = X[range.vertex_begin];
  m.drift = U[range.vertex_begin];
  for (std::int32_t t = range.triangle_begin; t < range.triangle_end; ++t) {
    const std::int32_t a = cells.triangles.a[t], b = cells.triangles.b[t], c = cells.triangles.c[t];
    const V3 p = X[a] - m.origin, q = X[b] - m.origin, r = X[c] - m.origin;
    const V3 dp = U[a] - m.drift, dq = U[b] - m.drift, dr = U[c] - m.drift;
    const V3 qr = cross(q, r);
    const double V = dot(p, qr) / 6;
    const double V_rate = (dot(dp, qr) + dot(dq, cross(r, p)) + dot(dr, cross(p, q))) / 6;
    const V3 centre = 0.25 * (p + q + r), centre_rate = 0.25 * (dp + dq + dr);
    m.V += V;
    m.V_rate += V_rate;
    m.first = m.first + V * centre;
    m.first_rate = m.first_rate + (V_rate * centre + V * centre_rate);
  }
  return m;
}

Vec3 centre(const VolumeMoments& m) { return to_vec3(m.origin + (1 / m.V) * m.first); }

Vec3 centre_velocity(const VolumeMoments& m) {
  return to_vec3(m.drift + (1 / m.V) * (m.first_rate - (m.V_rate / m.V) * m.first));
}

}  // namespace

std::string place_of(const Cells& cells, std::size_t cell) {
  const Vec3 mean = vertex_mean(cells.X, cells.ranges[cell]);
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) node spacings", mean[0], mean[1], mean[2]);
}

Vec3 vertex_mean(const VectorArray& values, const CellRange& range) {
  const auto mean = [&](const Array<double>& component) {
    return ordered_sum(range.vertex_begin, range.vertex_end, [&](std::ptrdiff_t v) { return component[v]; }) /
           (range.vertex_end - range.vertex_begin);
  };
  return {mean(values.x), mean(values.y), mean(values.z)};
}

Vec3 centre_of_mass(const Cells& cells, std::size_t cell) { return centre(volume_moments(cells, cell)); }

Vec3 centre_of_mass_velocity(const Cells& cells, std::size_t cell) {
  return centre_velocity(volume_moments(cells, cell));
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
  const VolumeMoments moments = volume_moments(cells, cell);
  CellMeasures m;
  m.centre_of_mass = centre(moments);
  m.velocity = centre_velocity(moments);
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
