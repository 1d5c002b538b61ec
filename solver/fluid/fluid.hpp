// SPDX-License-Identifier: BSD-3-Clause
// The fluid of one block: its populations, its velocity, and the force density that acts on it.
#pragma once

#include "base/halo.hpp"
#include "base/vec3.hpp"
#include "fluid/populations.hpp"

namespace rouleau {

/// Lattice units, reference density 1.
///
/// What a checkpoint must hold is `f` at the owned nodes, and nothing else: the populations after the last collision,
/// before they stream. Halos and nodes beyond walls are rebuilt from it (exchange or `fill_periodic`, then
/// `fill_walls`); `f_next` is scratch; `u` and `g` are made anew in each step. `f` and `f_next` are swapped by each
/// step: do not keep pointers.
template <class Real>
struct Fluid {
  Lattice lattice;
  Block block;
  std::array<std::array<Vec3, 2>, 3>
      wall_velocity;         ///< [axis][side], used on axes that are not periodic; within the wall
  Populations<Real> f;       ///< f_q - w_q after collision: the state
  Populations<Real> f_next;  ///< what the step in progress writes
  VectorField<Real> u;       ///< velocity, halo 2; set by a step in the rows that want it
  VectorField<Real> g;       ///< membrane force per volume, halo 0; read by a step
  Array<Real> inside_row;    ///< [x] workspace of `collide_and_stream`: the flags of one row

  Fluid(const Lattice& whole, const Block& owned)
      : lattice(whole),
        block(owned),
        f(owned.size),
        f_next(owned.size),
        u{Field<Real>(owned.size, 2), Field<Real>(owned.size, 2), Field<Real>(owned.size, 2)},
        g{Field<Real>(owned.size, 0), Field<Real>(owned.size, 0), Field<Real>(owned.size, 0)},
        inside_row(static_cast<std::size_t>(owned.size[0])) {
    for (auto& sides : wall_velocity) sides.fill(Vec3::Zero());
  }
};

/// All of the lattice in one block.
inline Block whole_block(const Lattice& lattice) { return {{0, 0, 0}, lattice.size}; }

/// Fills the velocity halo along an axis whose period lies within the block. Call for x, y, z in this order.
template <class Real>
void fill_periodic_velocity(Fluid<Real>& fluid, int axis) {
  for (Field<Real>& component : fluid.u) fill_periodic(component, axis);
}

}  // namespace rouleau
