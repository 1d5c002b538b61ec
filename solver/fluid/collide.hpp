// SPDX-License-Identifier: BSD-3-Clause
// One step of the fluid: pull the populations from the neighbours, collide, write.
#pragma once

#include <cstdint>
#include <span>

#include "fluid/fluid.hpp"
#include "fluid/rates.hpp"

namespace rouleau {

/// One byte for each owned row (j, k), at j + size_y k; an empty mask stands for all rows.
struct RowMasks {
  std::span<const std::uint8_t> has_force{};       ///< rows in which `g` may differ from zero; elsewhere it is not read
  std::span<const std::uint8_t> wants_velocity{};  ///< rows of `u` to set; the others keep stale values
};

/// Streams and collides every owned node.   Eqs. 1-4 of the paper, force of [Guo2002]
/// reads  fluid.f with its halos filled, fluid.g, `inside` (1: inside a cell; owned nodes), `body_force` (force per
/// volume) sets   fluid.f (owned nodes; swapped with f_next), fluid.u = (sum c f + (body_force + g)/2) / rho in the
/// wanted rows leaves the halos of fluid.f and fluid.u to be filled by the caller The masks choose what is computed,
/// never its bits: a row with force 0 and one without have the same result.
template <class Real>
void collide_and_stream(Fluid<Real>& fluid, const Collision& collision, const Field<std::uint8_t>& inside,
                        const Vec3& body_force, const RowMasks& masks = {});

extern template void collide_and_stream(Fluid<float>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                        const RowMasks&);
extern template void collide_and_stream(Fluid<double>&, const Collision&, const Field<std::uint8_t>&, const Vec3&,
                                        const RowMasks&);

}  // namespace rouleau
