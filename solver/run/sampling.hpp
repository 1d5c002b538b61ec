// SPDX-License-Identifier: BSD-3-Clause
// What a sample is: the columns of samples.csv and how each follows from the state.
#pragma once

#include <string>
#include <vector>

#include "run/simulation.hpp"
#include "storage/sample_log.hpp"

namespace rouleau {

/// Column names without `check` (share/contract.md section 4).
std::vector<std::string> sample_columns();

struct Sample {
  std::vector<SampleRow> rows;              ///< one a cell; one with cell = 0 and no cell measures if there are none
  std::optional<double> d_um, asphericity;  ///< of the first cell
};

/// Measures the state as it is now. Collective; all ranks get the same values.
Sample take_sample(const Simulation& simulation, const Setup& setup);

}  // namespace rouleau
