// SPDX-License-Identifier: BSD-3-Clause
// Run files for tests: the paper's channel, with lines to add.
#pragma once

#include <string>

#include "run/feasibility.hpp"

namespace rouleau::test {

/// PHYSICS: dx = 1/3 um, 128 x 36 x 30 nodes, dt = 0.154321 us, v = 1.5 mm/s, R = 4 um. Each argument is added to its
/// section.
struct RunText {
  std::string fluid{}, channel{}, flow = "mean_velocity_mm_per_s = 1.5";
  std::string cell{}, membrane{}, numerics{}, time = "end_time_s = 9.2593", output{}, bounds{}, more{};
  std::string lengths = "length_x_um = 128/3\nlength_y_um = 12\nlength_z_um = 10";
  std::string spacing = "node_spacing_um = 1/3\ntime_step_us = 0.154321";

  [[nodiscard]] std::string text() const {
    return "[fluid]\n" + fluid + "\n[channel]\n" + lengths + "\n" + channel + "\n[flow]\n" + flow + "\n[cell]\n" +
           cell + "\n[membrane]\n" + membrane + "\n[numerics]\n" + spacing + "\n" + numerics + "\n[time]\n" + time +
           "\n[output]\n" + output + "\n[bounds]\n" + bounds + "\n" + more + "\n";
  }
};

/// A run file with what follows from it.
struct Read {
  RunFile run;
  Units units;
  LatticeParameters lattice;

  explicit Read(const std::string& text)
      : run(parse_run_file(text, "run.ini")), units(run.parameters), lattice(lattice_parameters(run, units)) {}
  explicit Read(const RunText& text) : Read(text.text()) {}
  [[nodiscard]] std::vector<std::string> warnings() const { return check_feasibility(run, lattice, units); }
  [[nodiscard]] DimensionlessNumbers numbers() const { return dimensionless_numbers(run, lattice, units); }
};

}  // namespace rouleau::test
