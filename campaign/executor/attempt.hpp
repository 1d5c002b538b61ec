// SPDX-License-Identifier: BSD-3-Clause
// The files that a manager makes in a run directory: attempts with their owner, and the stop file.
#pragma once

#include <filesystem>
#include <string>

namespace rouleau::campaign {

/// 32 random hex digits.
[[nodiscard]] std::string new_token();

/// attempts/<number> of a run directory.
[[nodiscard]] std::filesystem::path attempt_directory(const std::filesystem::path& run_directory, int number);

/// Makes attempts/<number>/ with its owner file: from now on no older attempt may write (share/contract.md section 8).
/// throws Error (failed) if the attempt is there already: somebody else has taken the point over
void claim_attempt(const std::filesystem::path& run_directory, int number, const std::string& token);

/// Makes or removes the file that asks a solver to stop. Both may be repeated.
void make_stop_file(const std::filesystem::path& run_directory);
void remove_stop_file(const std::filesystem::path& run_directory);

/// The last line of a text file that is not empty, at most 300 bytes of it; "" if there is none.
[[nodiscard]] std::string last_line(const std::filesystem::path& file);

}  // namespace rouleau::campaign
