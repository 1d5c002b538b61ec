// SPDX-License-Identifier: BSD-3-Clause
// A sphere held at rest in a periodic cube of moving fluid, by the coupling that membranes have: how large is it?
#pragma once

#include "coupling/stencils.hpp"
#include "membrane/cells.hpp"
#include "support/one_block.hpp"

namespace rouleau::validation {

/// A mesh of `radius` whose vertices stand still: each adds up force against the velocity that it hears, until it hears
/// none. The fluid keeps its mean velocity: a body force of equal size acts the other way.
class FixedSphere {
 public:
  /// Lengths in node spacings. Edges are about 1.2 long: patterns of force on a finer mesh escape
  /// a trilinear kernel, and the force creeps upwards with the logarithm of time. Mean velocity along x.
  FixedSphere(Kernel kernel, double radius, int box, double nu, double mean_velocity);

  /// Steps until the force has settled.
  /// returns the force of the fluid on the sphere along x; that on all nodes, the inside included
  /// throws  Error(physics) if it does not settle
  double settled_force();

  /// Root mean square speed that the vertices hear, over the mean velocity: 0 for no slip.
  [[nodiscard]] double slip() const;

 private:
  void step();

  double nu_, mean_velocity_;
  testing::OneBlock<double> block_;
  Cells cells_;
  Stencils stencils_;
};

/// Drag of a cubic array of spheres over Stokes' for one: F = 6 pi mu a U K, U the mean over the cube.   [Hasimoto1959]
double hasimoto_factor(double radius, double box);

/// The radius whose drag in such an array is `force`.
double hydrodynamic_radius(double force, double viscosity, double mean_velocity, double box);

}  // namespace rouleau::validation
