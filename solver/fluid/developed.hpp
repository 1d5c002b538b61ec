// SPDX-License-Identifier: BSD-3-Clause
// The steady laminar flow that a uniform body force drives along x through a rectangular channel, or between two
// plates.
#pragma once

#include "base/grid.hpp"

namespace rouleau {

/// Velocities are those of G / (rho nu) = 1 (body force per volume over viscosity): multiply by it. Lengths in nodes.
/// A width is infinite along a periodic axis.   [White, Viscous Fluid Flow, eq. 3-48]
class DevelopedFlow {
 public:
  /// throws Error(bad_input) unless at least one width is finite and both are positive
  DevelopedFlow(double width_y, double width_z);
  /// The channel of a lattice whose walls lie half a node beyond its last nodes.
  explicit DevelopedFlow(const Lattice& lattice);

  /// At distances y, z from the channel axis.
  [[nodiscard]] double velocity(double y, double z) const;
  /// Over the cross-section. Also the time constant: the flow at rest under a force G approaches `mean` G/nu in about
  /// `mean`/nu steps.
  [[nodiscard]] double mean() const { return mean_; }
  /// On the axis.
  [[nodiscard]] double maximum() const { return velocity(0, 0); }

 private:
  double width_y_, width_z_, mean_;
};

}  // namespace rouleau
