// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of a cell: where it is, how it is stretched, how it lies.
#pragma once

#include <Eigen/Core>
#include <string>

#include "membrane/cells.hpp"

namespace rouleau {

/// Mean of a vector over a cell's vertices, summed in a fixed order.   [Lehmann2020] Eq. 17
Vec3 vertex_mean(const VectorArray& values, const CellRange& range);

/// "at (x, y, z) node spacings", the mean of a cell's vertices, for a message.
std::string place_of(const Cells& cells, std::size_t cell);

/// Centre of the enclosed volume, by the divergence theorem.
Vec3 centre_of_mass(const Cells& cells, std::size_t cell);

/// Time derivative of centre_of_mass when the vertices move with cells.U.
Vec3 centre_of_mass_velocity(const Cells& cells, std::size_t cell);

/// Gyration tensor about the mean of the vertices.   [Lehmann2020] Eq. 18
Eigen::Matrix3d gyration_tensor(const VectorArray& X, const CellRange& range);

/// Asphericity from the gyration tensor's eigenvalues: sum (l_i - l_j)^2 / (2 Rg^4), Rg^2 = sum l_i; 0 sphere, 1 rod.
/// [Lehmann2020] Eq. 19 with the square of the denominator that its print lost.
double asphericity(const Eigen::Matrix3d& gyration);

/// Angle in degrees, in [-90, 90], between x and the longest principal axis seen in the x-z plane. Where two axes are
/// equally long, as of a disc, the axis is not unique and neither is the angle.
double inclination_deg(const Eigen::Matrix3d& gyration);

/// Largest minus smallest coordinate of a cell along x, y, z.
Vec3 extents(const VectorArray& X, const CellRange& range);

/// All of it for one cell.
struct CellMeasures {
  Vec3 centre_of_mass = Vec3::Zero();  ///< lattice units, not unwrapped
  Vec3 velocity = Vec3::Zero();        ///< of the centre of mass
  Vec3 vertex_mean = Vec3::Zero();
  Vec3 extents = Vec3::Zero();
  double volume = 0, area = 0;
  double volume_ratio = 0, area_ratio = 0;  ///< V/V0, A/A0
  double asphericity = 0;
  double inclination_deg = 0;
};

CellMeasures measure(const Cells& cells, std::size_t cell);

}  // namespace rouleau
