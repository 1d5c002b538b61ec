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
void tracking(Suite& suite);

/// In the order in which they run.
std::span<const Case> all_cases();

}  // namespace rouleau::validation
