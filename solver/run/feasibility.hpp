// SPDX-License-Identifier: BSD-3-Clause
// What cannot work is refused before the first step, what is doubtful is warned about; both name the remedy.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "run/dimensionless_numbers.hpp"

namespace rouleau {

/// What is known of a cell's mesh once it is placed; lattice units.
struct MeshFacts {
  double edge_min = 0, edge_mean = 0, edge_max = 0;
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  ///< bounding box, node coordinates
  std::array<std::size_t, 2> pulled{};              ///< vertices at the low and high end that [stretch] pulls
};

/// Checks all that needs no mesh. Returns the warnings.
/// throws Error(bad_input) naming the parameter, its line, the limit and the remedy
std::vector<std::string> check_feasibility(const RunFile& run, const LatticeParameters& lattice, const Units& units);

/// Checks the bounding box of cell `cell` (0, 1, ...), node coordinates, against the walls and its own periodic images.
/// Returns the warnings. check_feasibility does this for generated shapes, check_mesh_feasibility for the others.
/// throws Error(bad_input)
std::vector<std::string> check_box(const RunFile& run, const LatticeParameters& lattice, std::size_t cell,
                                   const Vec3& lower, const Vec3& upper);

/// Checks the placed mesh of cell `cell`: edges against the spacing; of a loaded mesh also size and box. Returns the
/// warnings. throws Error(bad_input)
std::vector<std::string> check_mesh_feasibility(const RunFile& run, const LatticeParameters& lattice, std::size_t cell,
                                                const MeshFacts& mesh);

}  // namespace rouleau
