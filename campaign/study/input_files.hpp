// SPDX-License-Identifier: BSD-3-Clause
// What a run reads, and whether it is still what `init` wrote: damaged input would be run as other physics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/point.hpp"

namespace rouleau::campaign {

/// run.ini, and the campaign's copies of the files that it names, as seen from the run directory.
[[nodiscard]] std::vector<std::string> input_files(const std::filesystem::path& run_directory);

/// The text of points/<key>/inputs: a line "CRC SIZE FILE" an input file, as the program `cksum` has it.
[[nodiscard]] std::string input_sums(const std::filesystem::path& run_directory);

/// Throws Error (damaged) naming the file and the remedy if one is not what was written with point.json.
void require_input_files(const std::filesystem::path& run_directory, const Point& point);

}  // namespace rouleau::campaign
