// SPDX-License-Identifier: BSD-3-Clause
// What could be written next on a command line of rouleau-solver; share/completion asks it for bash and zsh.
#pragma once

#include <string>
#include <vector>

namespace rouleau {

/// The candidates for the last of `words` (those behind the program's name), a line each: text, tab, meaning. The text
/// `<files>` means that files are possible.
std::string completions(const std::vector<std::string>& words);

}  // namespace rouleau
