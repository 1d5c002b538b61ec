// SPDX-License-Identifier: BSD-3-Clause
// Moving a surface: scale, rotate, translate.
#include "membrane/transform.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"

namespace rouleau {

void scale(Surface& surface, double factor) {
  if (!(factor > 0) || !std::isfinite(factor)) {
    fail(Exit::bad_input, "cell: scale = {} must be positive and finite.", factor);
  }
  for (std::size_t v = 0; v < surface.X.size(); ++v) set(surface.X, v, factor * at(surface.X, v));
}

void rotate(Surface& surface, const Vec3& axis, double angle) {
  if (!axis.allFinite() || !(axis.norm() > 0) || !std::isfinite(angle)) {
    fail(Exit::bad_input, "cell: rotation about ({}, {}, {}) by {} rad: the axis must not be zero, and all be finite.",
         axis[0], axis[1], axis[2], angle);
  }
  if (angle == 0) return;  // unrotated cells keep their bits
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (std::size_t v = 0; v < surface.X.size(); ++v) set(surface.X, v, rotation * at(surface.X, v));
}

void translate(Surface& surface, const Vec3& shift) {
  for (std::size_t v = 0; v < surface.X.size(); ++v) set(surface.X, v, at(surface.X, v) + shift);
}

}  // namespace rouleau
