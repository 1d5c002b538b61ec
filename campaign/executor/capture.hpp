// SPDX-License-Identifier: BSD-3-Clause
// Running a program to its end, or to its time-out, and reading what it says.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// What a program that ran to its end has said.
struct Capture {
  int status = 0;  ///< exit status; 128 + signal if a signal ended it
  std::string out;
  std::string err;
  bool timed_out = false;  ///< it was killed, with all that it had started in its process group
};

struct CaptureSettings {
  std::filesystem::path directory;  ///< to run in; empty = the current one
  double time_out_s = 0;            ///< 0 = none. With one, it is shielded from the terminal's Ctrl-C
  std::optional<std::vector<std::string>> environment;  ///< "NAME=value" each; nothing = ours
};

/// Runs a program to its end with stdin from /dev/null. Arguments are handed over as they are: no shell is involved.
/// throws Error (failed) if it cannot be started
[[nodiscard]] Capture run_and_capture(const std::vector<std::string>& command, const CaptureSettings& settings);

/// The same in `directory` unless that is empty, without a time-out.
[[nodiscard]] Capture run_and_capture(const std::vector<std::string>& command,
                                      const std::filesystem::path& directory = {});

/// Our environment without the variables that Slurm's programs take for options or that describe the job we may be in.
/// A job submitted with them would be given the size of that one. Kept: SLURM_CONF and SLURM_JWT, which say where and
/// who.
[[nodiscard]] std::vector<std::string> environment_without_slurm();

}  // namespace rouleau::campaign
