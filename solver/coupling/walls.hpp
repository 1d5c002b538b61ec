// SPDX-License-Identifier: BSD-3-Clause
// The wall rule: what becomes of the part of a stencil that falls beyond a wall.
//
// Nodes beyond a half-way wall (at -1/2 or N - 1/2) do not exist.
//   Spreading   reflects: the weight of node -1 - i goes to its mirror image i, and that of N + i to N - 1 - i. The
//   force
//               that arrives in the fluid is therefore exactly the force of the membrane, however near the wall is.
//   Reading     takes the wall's own velocity there (no slip): the weight is dropped if the wall stands, and multiplies
//   the
//               wall's velocity if it moves. Where two walls meet, the wall of the later axis counts (z before y before
//               x).
// The two are no longer adjoint to each other within one kernel radius of a wall: a standing wall takes up momentum,
// the spreading must not.
#pragma once

#include <algorithm>
#include <array>

#include "base/vec3.hpp"

namespace rouleau {

/// Velocity of the wall at the low (0) and the high (1) end of each axis: [axis][side]; unused along periodic axes.
struct WallVelocities {
  std::array<std::array<Vec3, 2>, 3> u{
      {{Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero()}}};
};

/// A stencil along one axis that lies on the lattice as a whole: its first node, and its weights.
template <int width>
struct AxisStencil {
  int first;
  std::array<double, width> weight;
  std::array<double, 2> beyond{};  ///< weight that fell beyond the low and the high wall (reading only)
};

/// Moves a stencil's first node so that all its nodes are in [0, n). Needs n >= width.
constexpr int first_on_lattice(int first, int width, int n) { return std::clamp(first, 0, n - width); }

/// The stencil for spreading along a walled axis of n >= width nodes.
template <int width>
AxisStencil<width> reflected(int first, const double* weight, int n) {
  AxisStencil<width> s{first_on_lattice(first, width, n), {}, {}};
  for (int a = 0; a < width; ++a) {
    int node = first + a;
    if (node < 0) node = -1 - node;
    if (node >= n) node = 2 * n - 1 - node;
    s.weight[static_cast<std::size_t>(node - s.first)] += weight[a];
  }
  return s;
}

/// The stencil for reading along a walled axis of n >= width nodes.
template <int width>
AxisStencil<width> dropped(int first, const double* weight, int n) {
  AxisStencil<width> s{first_on_lattice(first, width, n), {}, {}};
  for (int a = 0; a < width; ++a) {
    const int node = first + a;
    if (node < 0)
      s.beyond[0] += weight[a];
    else if (node >= n)
      s.beyond[1] += weight[a];
    else
      s.weight[static_cast<std::size_t>(node - s.first)] = weight[a];
  }
  return s;
}

}  // namespace rouleau
