// SPDX-License-Identifier: BSD-3-Clause
// Finding `rouleau-solver` and asking it questions that it answers at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/check.hpp"

namespace rouleau::campaign {

/// ROULEAU_SOLVER if set, else beside this program, else on the PATH.   throws Error (failed) naming all three
[[nodiscard]] std::filesystem::path find_solver();

/// What a program that ran to its end has said.
struct Capture {
  int status = 0;  ///< exit status; 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

/// Runs a program to its end with stdin from /dev/null, in `directory` unless that is empty.
/// throws Error (failed) if it cannot be started
[[nodiscard]] Capture run_and_capture(const std::vector<std::string>& command,
                                      const std::filesystem::path& directory = {});

/// A Checker that writes each run file into a scratch directory of its own and calls `solver check`.
[[nodiscard]] Checker solver_checker(const std::filesystem::path& solver);

/// A new directory below the system's temporary one; removed with everything in it at the end of the scope.
class ScratchDirectory {
 public:
  ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ~ScratchDirectory();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rouleau::campaign
