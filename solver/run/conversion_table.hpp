// SPDX-License-Identifier: BSD-3-Clause
// The conversion from the user's units to the lattice's as a text, printed at the start of a run and stored with it.
#pragma once

#include <string>
#include <vector>

#include "run/feasibility.hpp"

namespace rouleau {

/// Lines of text, each ended. `meshes` has an entry a cell, or none where the meshes are not built yet.
std::string conversion_table(const RunFile& run, const LatticeParameters& lattice, const Units& units,
                             const std::vector<MeshFacts>& meshes);

}  // namespace rouleau
