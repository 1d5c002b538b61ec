// SPDX-License-Identifier: BSD-3-Clause
// The flag lattice: which nodes are inside a cell.
#pragma once

#include <cstdint>

#include "base/grid.hpp"

namespace rouleau {

/// 1 inside a cell, 0 outside. One halo node; beyond walls its content means nothing.
using Flags = Field<std::uint8_t>;

/// Inside nodes among those owned.
std::int64_t count_inside(const Flags& flags);

/// Sets all owned nodes to outside.
void clear_owned(Flags& flags);

}  // namespace rouleau
