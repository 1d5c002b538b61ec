// SPDX-License-Identifier: BSD-3-Clause
// Measuring the solver's speed on a point for a few seconds, beside the campaign.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/run_file.hpp"

namespace rouleau::campaign {

struct Calibration {
  double mlups = 0;
  double seconds = 0;   ///< that it took
  std::string trouble;  ///< why there is no figure; empty: there is one
};

/// Runs `jobs` solvers side by side, as the campaign will (they share caches and memory), each on a copy of the run
/// file in a scratch directory, with `ranks` on the cores of this process, until a deadline of about `seconds`. The
/// result is the mean of one. The run file's own files are found below `files` by their stored names.
[[nodiscard]] Calibration calibrate(const std::string& run_file, const std::filesystem::path& files, double seconds,
                                    int ranks, int jobs);

}  // namespace rouleau::campaign
