// SPDX-License-Identifier: BSD-3-Clause
// What the user asked rouleau-solver to do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "run/attempt_run.hpp"
#include "run/command_table.hpp"

namespace rouleau {

struct CommandLine {
  Verb verb = Verb::run;
  std::filesystem::path file;  ///< of check, inspect, verify and shape
  bool json = false;
  std::optional<int> slice_normal;  ///< of shape: 1 for y, 2 for z
  std::vector<std::string> words;   ///< to complete, behind the program's name
  RunOptions run;
};

/// throws Error(usage) with one line that names the word and what is possible instead
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace rouleau
