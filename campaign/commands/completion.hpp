// SPDX-License-Identifier: BSD-3-Clause
// What could be written next on a command line of `rouleau`; share/completion asks it for bash and zsh.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "commands/cli.hpp"

namespace rouleau::campaign {

/// `rouleau --complete WORD...` prints the candidates for the last word, a line each: text, tab, meaning.
inline constexpr const char* complete_option = "--complete";

/// In place of a text: the shell may offer files, or directories.
inline constexpr const char* any_file = "<files>";
inline constexpr const char* any_directory = "<directories>";

struct Candidate {
  std::string text;  ///< the whole word; one that ends with `=` is to be continued
  std::string meaning;
};

/// The candidates for the last of `words` (those behind `rouleau`), by the tables of --help and the campaign that they
/// name. Where there is no campaign, none of its columns and points.
[[nodiscard]] std::vector<Candidate> completions(std::span<const Verb* const> verbs,
                                                 const std::vector<std::string>& words);

}  // namespace rouleau::campaign
