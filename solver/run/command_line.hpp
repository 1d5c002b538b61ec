// SPDX-License-Identifier: BSD-3-Clause
// What the user asked rouleau-solver to do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "run/attempt_run.hpp"

namespace rouleau {

enum class Verb { run, check, inspect, verify, shape, help, help_run_file, version };

struct CommandLine {
  Verb verb = Verb::run;
  std::filesystem::path file;  ///< of check, inspect, verify and shape
  bool json = false;
  std::optional<int> slice_normal;  ///< of shape: 1 for y, 2 for z
  RunOptions run;
};

/// throws Error(usage) with one line that names the word and what is possible instead
CommandLine parse_command_line(int argc, const char* const* argv);

/// The answer to --help: an example first, then every option.
std::string help_text();

}  // namespace rouleau
