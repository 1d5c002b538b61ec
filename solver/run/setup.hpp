// SPDX-License-Identifier: BSD-3-Clause
// Everything that is fixed before the first step: what `check` shows and what a simulation starts from.
#pragma once

#include <string>
#include <vector>

#include "run/cell_setup.hpp"
#include "run/lattice_parameters.hpp"
#include "run/run_file.hpp"
#include "run/units.hpp"

namespace rouleau {

struct Setup {
  RunFile run;
  Units units;
  LatticeParameters lattice;
  CellSetup cells;
  std::vector<std::string> warnings;
};

/// Reads the run file and the meshes that it names, converts, refuses what cannot work.
/// throws Error(bad_input), Error(io)
Setup set_up(const std::filesystem::path& run_file, FileSystem& files);

/// Bytes of a checkpoint of this run.
std::int64_t checkpoint_bytes(const Setup& setup);

}  // namespace rouleau
