// SPDX-License-Identifier: BSD-3-Clause
// A fluid that fills its lattice with one block, and the loop that steps it: what flow tests have in common.
#pragma once

#include "fluid/collide.hpp"
#include "fluid/flow_rate.hpp"
#include "fluid/walls.hpp"

namespace rouleau::testing {

template <class Real>
struct OneBlock {
  Fluid<Real> fluid;
  Collision collision;
  Field<std::uint8_t> inside;
  Vec3 body_force = Vec3::Zero();

  OneBlock(const Lattice& lattice, const Collision& law)
      : fluid(lattice, whole_block(lattice)), collision(law), inside(lattice.size, 1) {}

  void step(const MembraneRows& membranes = {}) {
    fill_halos(fluid);
    collide_and_stream(fluid, collision, inside, body_force, membranes);
  }
  void run(int steps) {
    for (int n = 0; n < steps; ++n) step();
  }
  [[nodiscard]] double u(int axis, int i, int j, int k) const { return fluid.u[axis](i, j, k); }
};

template <class Real>
std::array<std::int64_t, 3> total_momentum(const Fluid<Real>& fluid) {
  return {momentum_fixed_point(fluid, 0), momentum_fixed_point(fluid, 1), momentum_fixed_point(fluid, 2)};
}

inline Collision one_trt(double nu, double magic = exact_wall_magic) {
  return TwoFluids<TrtRates<>>{trt_rates(nu, magic), trt_rates(nu, magic)};
}

inline Collision two_trt(double nu_outside, double nu_inside, double magic = exact_wall_magic) {
  return TwoFluids<TrtRates<>>{trt_rates(nu_outside, magic), trt_rates(nu_inside, magic)};
}

/// Smooth and without symmetry, of size 1: for initial states that exercise every direction.
inline Vec3 swirl(const Int3& node) {
  const double x = node[0], y = node[1], z = node[2];
  return {std::sin(0.9 * y + 0.3 * z), std::cos(0.7 * z + 0.2 * x + 1), std::sin(0.5 * x - 0.8 * y + 2)};
}

}  // namespace rouleau::testing
