// SPDX-License-Identifier: BSD-3-Clause
// The texts of --help, which the manual page repeats.
#pragma once

#include <array>
#include <iosfwd>
#include <span>

#include "commands/cli.hpp"

namespace rouleau::campaign {

/// A word and what it means, in lists.
struct Meaning {
  const char* word;
  const char* meaning;
};

inline constexpr const char* program_summary =
    "campaigns of red-blood-cell simulations, from a study file to a phase table";

inline constexpr const char* first_examples =
    "  rouleau init study.ini my-campaign     make a campaign from a study file\n"
    "  rouleau run my-campaign                run it; again after any interruption or crash\n"
    "  rouleau status my-campaign             how far is it?\n"
    "  rouleau query my-campaign              the phase table so far\n"
    "  rouleau report my-campaign             figures and tables as one HTML file\n";

inline constexpr std::array<Meaning, 3> program_options = {
    {{"--help", "this text"},
     {"--man", "this as a manual, for man -l -; also --man study, --man cluster"},
     {"--version", "versions of rouleau and of what it is built with"}}};

inline constexpr std::array<Meaning, 9> exit_codes = {{{"0", "ok"},
                                                       {"1", "failed"},
                                                       {"2", "wrong usage or study file"},
                                                       {"3", "nothing found"},
                                                       {"4", "some points failed"},
                                                       {"5", "locked by another live process"},
                                                       {"6", "engine does not answer"},
                                                       {"7", "damage found"},
                                                       {"130", "interrupted"}}};

inline constexpr std::array<Meaning, 3> environment = {
    {{"ROULEAU_SOLVER", "the rouleau-solver to use; else the one beside rouleau, else the one on the PATH"},
     {"NO_COLOR", "if set: no colours"},
     {"TMPDIR", "where scratch files go; else /tmp"}}};

inline constexpr const char* how_points_are_named =
    "A POINT is #3 (the third one; quote it: '#3'), name=value such as lambda=5, a key, or the unique beginning of "
    "one.";

/// The answer to `rouleau --help`.
void print_overview(std::span<const Verb* const> verbs, std::ostream& out);

/// The answer to `rouleau VERB --help`.
void print_help(const Verb& verb, std::ostream& out);

}  // namespace rouleau::campaign
