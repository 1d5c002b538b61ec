// SPDX-License-Identifier: BSD-3-Clause
// The fluid of one block: its populations, its velocity, and the force density that acts on it.
#pragma once

#include "base/halo.hpp"
#include "base/vec3.hpp"
#include "fluid/populations.hpp"

namespace rouleau {

/// Nodes beyond a block whose velocity a kernel of four points may read.
inline constexpr int velocity_halo = 2;

/// Lattice units, reference density 1.
///
/// What a checkpoint must hold is `f` at the owned nodes, and nothing else: the populations after the last collision,
/// before they stream. Halos and nodes beyond walls are rebuilt from it (exchange or `fill_periodic`, then
/// `fill_walls`); `u` and `g` are made anew in each step. A step renumbers the rows of `f`: do not keep pointers.
template <class Real>
struct Fluid {
  Lattice lattice;
  Block block;
  std::array<std::array<Vec3, 2>, 3>
      wall_velocity;       ///< [axis][side], used on axes that are not periodic; within the wall
  Populations<Real> f;     ///< f_q - w_q after collision: the state
  VectorField<Real> u;     ///< velocity; set by a step in the rows that want it
  VectorField<Real> g;     ///< membrane force per volume, halo 0; read by a step
  Array<Real> inside_row;  ///< [x, to whole packs] workspace of `collide_and_stream`: the flags of one row

  Fluid(const Lattice& whole, const Block& owned)
      : lattice(whole),
        block(owned),
        f(owned.size),
        u{Field<Real>(owned.size, velocity_halo), Field<Real>(owned.size, velocity_halo),
          Field<Real>(owned.size, velocity_halo)},
        g{Field<Real>(owned.size, 0), Field<Real>(owned.size, 0), Field<Real>(owned.size, 0)},
        inside_row(static_cast<std::size_t>(owned.size[0]) + cache_line) {
    for (auto& sides : wall_velocity) sides.fill(Vec3::Zero());
  }

  /// Whether the rows close in themselves: x is periodic and not cut. Then a step needs no halo of f along x.
  [[nodiscard]] bool closes_x() const { return lattice.periodic[0] && block.size[0] == lattice.size[0]; }
};

/// All of the lattice in one block.
inline Block whole_block(const Lattice& lattice) { return {{0, 0, 0}, lattice.size}; }

}  // namespace rouleau
