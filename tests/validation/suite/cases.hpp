// SPDX-License-Identifier: BSD-3-Clause
// The cases, each in a file of its own name.
#pragma once

#include <span>

#include "suite.hpp"

namespace rouleau::validation {

void plane_channel(Suite& suite);
void duct(Suite& suite);
void two_layer(Suite& suite);
void membrane(Suite& suite);
void sphere_drag(Suite& suite);
void sphere_drift(Suite& suite);
void plug_flow(Suite& suite);
void centred_cell(Suite& suite);
void migration(Suite& suite);
void tracking(Suite& suite);
void capsule_small(Suite& suite);
void capsule_neo_hookean(Suite& suite);
void capsule_contrast(Suite& suite);
void capsule_kernels(Suite& suite);
void stretching(Suite& suite);
void keller_skalak(Suite& suite);

/// In the order in which they run.
std::span<const Case> all_cases();

}  // namespace rouleau::validation
