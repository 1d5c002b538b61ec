// SPDX-License-Identifier: BSD-3-Clause
#include "cases.hpp"

namespace rouleau::validation {
namespace {

constexpr Case table[] = {
    {"plane_channel", "force-driven flow between two plates, by collision law and viscosity", plane_channel},
    {"duct", "force-driven flow through the paper's channel: series, order, flow rate", duct},
    {"two_layer", "two fluids with a flat interface: order, known errors, staircase of the flags", two_layer},
    {"membrane", "energies, forces, volumes of meshes by themselves", membrane},
    {"sphere_drag", "drag of an array of spheres: the hydrodynamic radius of each kernel", sphere_drag},
    {"tracking", "flags of flowing cells against ray casting, by variant and correction interval", tracking},
};

}  // namespace

std::span<const Case> all_cases() { return table; }

}  // namespace rouleau::validation
