// SPDX-License-Identifier: BSD-3-Clause
// Inside or outside by the equation of the shape: for cells that have not moved yet.
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/grid.hpp"
#include "interior/flags.hpp"

namespace rouleau {

/// A body of known equation, lattice units.
struct Body {
  enum class Shape { ellipsoid, red_blood_cell };
  Shape shape = Shape::ellipsoid;
  Vec3 radii{1, 1, 1};  ///< semi-axes of an ellipsoid; a red blood cell takes R from the first, its disc axis is z
  Vec3 centre{0, 0, 0};
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< from the body's own axes to the lattice's
};

/// Flags the nodes inside any of the bodies: the paper's Eqs. (0), 14 and 15. Bodies may straddle periodic borders, and
/// may lie anywhere in periodic space.
/// sets flags  all owned nodes
void flag_bodies(std::span<const Body> bodies, const Lattice& lattice, const Block& block, Flags& flags);

}  // namespace rouleau
