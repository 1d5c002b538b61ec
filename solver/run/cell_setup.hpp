// SPDX-License-Identifier: BSD-3-Clause
// From the run file's [cell] sections to the membranes in the channel.
#pragma once

#include <vector>

#include "interior/analytic.hpp"
#include "membrane/assemble.hpp"
#include "membrane/markers.hpp"
#include "run/feasibility.hpp"
#include "storage/file_system.hpp"

namespace rouleau {

/// The cells of a run where they start, and what is known of them.
struct CellSetup {
  std::vector<CellStart> starts;  ///< lattice units, placed
  std::vector<MeshFacts> meshes;  ///< one a cell
  std::vector<Markers> markers;   ///< one a cell, vertex indices of all cells together
  std::vector<Body> bodies;       ///< one a cell if all have an equation; else empty, and flags come from ray casting
  std::vector<std::string> warnings;

  [[nodiscard]] std::int64_t vertices() const;
  [[nodiscard]] std::int64_t triangles() const;
};

/// Generates or reads each cell's mesh, checks it, scales, turns and places it. A mesh from a file or a checkpoint is
/// placed by its centre of mass. throws Error(bad_input) if a mesh is no closed outward surface, does not fit the
/// channel or the lattice; Error(io)
CellSetup set_up_cells(const RunFile& run, const LatticeParameters& lattice, FileSystem& files);

}  // namespace rouleau
