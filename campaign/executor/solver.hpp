// SPDX-License-Identifier: BSD-3-Clause
// Finding `rouleau-solver` and asking it questions that it answers at once.
#pragma once

#include <filesystem>

#include "executor/capture.hpp"
#include "study/check.hpp"

namespace rouleau::campaign {

/// ROULEAU_SOLVER if set, else beside this program, else on the PATH.   throws Error (failed) naming all three
[[nodiscard]] std::filesystem::path find_solver();

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
