// SPDX-License-Identifier: BSD-3-Clause
// The run file's choices as the objects of the core that carry them out.
#pragma once

#include <optional>

#include "coupling/delta.hpp"
#include "fluid/controller.hpp"
#include "fluid/rates.hpp"
#include "interior/tracker.hpp"
#include "run/setup.hpp"

namespace rouleau {

Collision collision_of(const Setup& setup);
Kernel kernel_of(const Setup& setup);
/// None: tracking is off, or there is no cell.
std::optional<Tracking> tracking_of(const Setup& setup);
/// None: the force is fixed.
std::optional<MeanVelocityController> controller_of(const Setup& setup);
/// [axis][low, high side]; the walls of z move along x if the flow is sheared.
std::array<std::array<Vec3, 2>, 3> wall_velocities_of(const Setup& setup);

}  // namespace rouleau
