// SPDX-License-Identifier: BSD-3-Clause
// One step of the fluid: pull the populations from the neighbours, collide, write.
#pragma once

#include <cstdint>
#include <span>

#include "fluid/fluid.hpp"
#include "fluid/rates.hpp"

namespace rouleau {

/// Where membranes touch the fluid: one byte for each owned row (j, k), at j + size_y k, whose bit s stands for the
/// nodes [s, s + 1) << segment_shift. No bytes at all stand for everywhere.
struct MembraneRows {
  std::span<const std::uint8_t> segments{};
  int segment_shift = 4;  ///< at least 4, and 8 << segment_shift at least the nodes of a row
};

/// Streams and collides every owned node.   Eqs. 1-4 of the paper, force of [Guo2002]
/// reads  fluid.f with its halos filled (not along x if fluid.closes_x()), fluid.g in the membranes' segments (0
///        elsewhere), `inside` (1: inside a cell; owned nodes), `body_force` (force per volume)
/// sets   fluid.f (owned nodes, rows renumbered), fluid.u = (sum c f + (body_force + g)/2) / rho in the membranes'
/// segments leaves the halos of fluid.f and fluid.u to be filled by the caller `membranes` chooses what is computed,
/// never its bits: a node with force 0 and one without have the same result.
template <class Real>
void collide_and_stream(Fluid<Real>& fluid, const Collision& collision, const Field<std::uint8_t>& inside,
                        const Vec3& body_force, const MembraneRows& membranes = {});

extern template void collide_and_stream(Fluid<float>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                        const MembraneRows&);
extern template void collide_and_stream(Fluid<double>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                        const MembraneRows&);

}  // namespace rouleau
