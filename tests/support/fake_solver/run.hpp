// SPDX-License-Identifier: BSD-3-Clause
// The fake run: steps that sleep, with everything around them that a manager sees.
#pragma once

#include <optional>
#include <string>

namespace fake {

struct Options {
  int attempt = 0;  ///< 0 = claim the next
  std::string token;
  std::optional<double> deadline_s;
};

/// Runs run.ini of the current directory.   returns the exit code, recorded in exit.json
int run(const Options& options);

}  // namespace fake
