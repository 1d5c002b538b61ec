// SPDX-License-Identifier: BSD-3-Clause
// The second moments of the volume that a membrane encloses, and the ellipse that has them.
#include "membrane/solid_moments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rouleau {

// A triangle and an origin o span a tetrahedron of volume V = a . (b x c) / 6; the integral of x x^T over it is
// V / 20 (a a^T + b b^T + c c^T + s s^T) with s = a + b + c, all from o. The first vertex is taken for o.
Eigen::Matrix3d solid_moments(const Cells& cells, std::size_t cell) {
  const CellRange& range = cells.ranges[cell];
  const Vec3 origin = at(cells.X, static_cast<std::size_t>(range.vertex_begin));
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::int32_t t = range.triangle_begin; t < range.triangle_end; ++t) {
    const auto corner = [&](const Array<std::int32_t>& of) -> Vec3 {
      return at(cells.X, static_cast<std::size_t>(of[t])) - origin;
    };
    const Vec3 a = corner(cells.triangles.a), b = corner(cells.triangles.b), c = corner(cells.triangles.c);
    const Vec3 sum = a + b + c;
    const double V = a.dot(b.cross(c)) / 6;
    volume += V;
    first += V / 4 * sum;
    second += V / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  const Vec3 centre = first / volume;
  return second / volume - centre * centre.transpose();
}

PlaneEllipse ellipse_in_plane(const Eigen::Matrix3d& solid_moments, int across) {
  const double along = solid_moments(0, 0), side = solid_moments(across, across), mixed = solid_moments(0, across);
  const double mean = 0.5 * (along + side), radius = std::hypot(0.5 * (along - side), mixed);
  PlaneEllipse ellipse;
  ellipse.longer = std::sqrt(5 * (mean + radius));
  ellipse.shorter = std::sqrt(5 * std::max(0.0, mean - radius));  // round-off of a body without thickness
  ellipse.angle_deg = 0.5 * std::atan2(2 * mixed, along - side) * 180 / std::numbers::pi;
  return ellipse;
}

}  // namespace rouleau
