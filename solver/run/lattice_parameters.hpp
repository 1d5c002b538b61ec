// SPDX-License-Identifier: BSD-3-Clause
// Everything that the solver's core needs from the run file, in lattice units.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/grid.hpp"
#include "membrane/cells.hpp"
#include "run/run_file.hpp"
#include "run/units.hpp"

namespace rouleau {

/// Where and how large a cell starts, jitter included. Coordinates are node coordinates (base/grid.hpp).
struct CellPlacement {
  Vec3 centre = Vec3::Zero();
  Vec3 rotation_axis = Vec3::UnitZ();  ///< of length 1
  double rotation_angle = 0;           ///< radians
  double radius = 0;                   ///< red blood cell, sphere; scale included
  Vec3 semi_axes = Vec3::Zero();       ///< ellipsoid; scale included
  double from_um = 0;                  ///< factor for a mesh given in um; scale included
  Vec3 half_extent =
      Vec3::Zero();  ///< of the bounding box; zero for meshes and checkpoints, whose size is not known yet
};

/// What [stretch] asks for.
struct StretchForce {
  std::optional<std::size_t> axis;  ///< none: nothing is pulled
  double force = 0;                 ///< on each end of a cell, once it is whole
  double share = 0;                 ///< of the vertices, at each end
  double ramp_steps = 0;

  /// The force in the step that follows `steps_done`: it rises as s^2 (3 - 2 s) with s = steps_done / ramp_steps.
  [[nodiscard]] double in_step_after(std::int64_t steps_done) const;
};

struct LatticeParameters {
  Lattice lattice;
  double nu_out = 0, nu_in = 0;
  double tau_out = 0, tau_in = 0;
  double mean_velocity = 0;  ///< to be held; 0 unless driving = mean_velocity
  double body_force = 0;  ///< along x, per volume: the fixed one, or the empty channel's for the wanted mean velocity
  double wall_velocity =
      0;  ///< of the upper z wall along x, the lower one's is -wall_velocity; 0 unless driving = shear
  double initial_velocity = 0;  ///< along x; 0 unless initial = uniform
  double max_velocity = 0;      ///< to be expected in the empty channel
  double max_to_mean = 1;       ///< of the developed profile; 1 without one
  Moduli moduli;                ///< zero without a cell
  StretchForce stretch;
  std::vector<CellPlacement> cells;
  std::int64_t steps = 0;  ///< to the end time
};

/// Converts a run file. The channel's driving is the empty channel's: rectangular duct, or plane channel if one of y, z
/// is periodic. throws Error(bad_input) if a length is no multiple of the node spacing (within 1e-6; names the nearest
/// that are), if the lattice is too small or too large, or if the end time is below one step
LatticeParameters lattice_parameters(const RunFile& run, const Units& units);

}  // namespace rouleau
