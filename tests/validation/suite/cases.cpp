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
    {"sphere_drift", "a stiff sphere off the middle of a flow does not drift across it", sphere_drift},
    {"plug_flow", "a cell in uniform flow is as at rest: shape, flags, no tail", plug_flow},
    {"centred_cell", "a cell on the axis stays on the axis", centred_cell},
    {"migration", "capsule and cell off the axis go towards it", migration},
    {"tracking", "flags of flowing cells against ray casting, by variant and correction interval", tracking},
    {"capsule_small", "spherical capsule in weak shear: the small-deformation limit for every lambda", capsule_small},
    {"capsule_neo_hookean", "neo-Hookean capsule in shear: deformation, angle and transient at two resolutions",
     capsule_neo_hookean},
    {"capsule_contrast", "Skalak capsule in strong shear: lambda 5 deforms less and later than lambda 1",
     capsule_contrast},
    {"capsule_kernels", "the same capsule by the 2-, 3- and 4-point kernel", capsule_kernels},
    {"stretching", "red blood cell between optical tweezers: diameters against force", stretching},
    {"keller_skalak", "tank-treading capsule: angle, frequency and onset of tumbling over lambda", keller_skalak},
};

}  // namespace

std::span<const Case> all_cases() { return table; }

}  // namespace rouleau::validation
