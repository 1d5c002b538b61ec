// SPDX-License-Identifier: BSD-3-Clause
// What is read off the flow of a block without rounding that depends on its cut: momentum, largest speed, first bad
// node.
#pragma once

#include <cstdint>
#include <optional>

#include "fluid/fluid.hpp"

namespace rouleau {

/// Units of the fixed-point momentum to 1: a node's momentum is rounded to a multiple of 2^-36 = 1.5e-11.
inline constexpr double momentum_scale = 68719476736.0;  // 2^36

/// A node's momentum must stay below it (Mach 0.22). With 2^30 = 1e9 nodes the sum stays within 2^30 2^36 / 8 = 2^63.
inline constexpr double largest_momentum = 0.125;

/// Sum over the owned nodes of sum_q c_q f_q along `axis` in units of 1 / momentum_scale. Each node is rounded by
/// itself (in the precision of the populations, then to the nearest unit, ties to even) and integers are added: the
/// total over ranks is the same for every decomposition. reads   fluid.f of owned nodes throws  Error(physics) with the
/// first node whose momentum is not finite or not below `largest_momentum`
template <class Real>
std::int64_t momentum_fixed_point(const Fluid<Real>& fluid, int axis);

/// Mean velocity along one axis from the total momentum of all `nodes` and the body force that acted in the last step:
/// the state holds the whole force, the velocity half of it. Membrane forces sum to zero. Mass flux over the reference
/// density 1.
inline double mean_velocity(std::int64_t total_momentum, std::ptrdiff_t nodes, double body_force) {
  return static_cast<double>(total_momentum) / momentum_scale / static_cast<double>(nodes) - 0.5 * body_force;
}

struct SpeedCheck {
  double max_speed = 0;               ///< over the nodes that are not bad
  std::optional<Int3> first_bad;      ///< global coordinates; the first in the order z, y, x of the block
  double bad_speed = 0, bad_rho = 0;  ///< of first_bad
};

/// Speed |sum c f| / rho of the owned nodes (the half force of a step left out), in the precision of the populations. A
/// node is bad if its speed is not finite or exceeds `limit`, or if its density is not between 0 and 2.
template <class Real>
SpeedCheck check_speed(const Fluid<Real>& fluid, double limit);

extern template std::int64_t momentum_fixed_point(const Fluid<float>&, int);
extern template std::int64_t momentum_fixed_point(const Fluid<double>&, int);
extern template SpeedCheck check_speed(const Fluid<float>&, double);
extern template SpeedCheck check_speed(const Fluid<double>&, double);

}  // namespace rouleau
