// SPDX-License-Identifier: BSD-3-Clause
// The second moments of the volume that a membrane encloses, and the ellipse that has them.
#pragma once

#include <Eigen/Core>

#include "membrane/cells.hpp"

namespace rouleau {

/// Integral of (x - c)(x - c)^T over the enclosed volume, divided by it, with c its centre. Of an ellipsoid with the
/// semi-axes a_i along the axes: a_i^2 / 5 on the diagonal. Exact for the polyhedron, however its vertices are spread.
Eigen::Matrix3d solid_moments(const Cells& cells, std::size_t cell);

/// How a body lies in the plane of x and another axis: the ellipse with the body's second moments there. Of an
/// ellipsoid that has one axis normal to the plane it is the section through its centre.
struct PlaneEllipse {
  double longer = 0, shorter = 0;  ///< semi-axes L and B
  double angle_deg = 0;            ///< from x to the longer one, towards the other axis, in (-90, 90]; 0 of a circle
  /// Taylor's deformation (L - B) / (L + B).
  [[nodiscard]] double deformation() const { return (longer - shorter) / (longer + shorter); }
};

/// In the plane of x and the axis `across` (1: y, 2: z).
PlaneEllipse ellipse_in_plane(const Eigen::Matrix3d& solid_moments, int across);

}  // namespace rouleau
