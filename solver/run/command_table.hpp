// SPDX-License-Identifier: BSD-3-Clause
// The tables of rouleau-solver's command line: questions, options, exit codes. Parsing, help, manual page and
// completion read them.
#pragma once

#include <array>
#include <boost/program_options/options_description.hpp>
#include <string>
#include <vector>

namespace rouleau {

enum class Verb {
  run,
  check,
  inspect,
  verify,
  shape,
  help,
  help_run_file,
  manual,
  manual_of_run_file,
  complete,
  version
};

/// A word in front of a file that asks something about it instead of running it.
struct Question {
  const char* word;
  Verb verb;
  const char* file;
  const char* meaning;
};

inline constexpr std::array<Question, 4> questions = {
    {{"check", Verb::check, "run.ini", "what would run: conversion table, cost, warnings"},
     {"inspect", Verb::inspect, "FILE.h5", "what a checkpoint holds"},
     {"verify", Verb::verify, "FILE.h5", "whether it is whole"},
     {"shape", Verb::shape, "FILE.h5", "the cells of a checkpoint or snapshot, as JSON"}}};

struct ExitCode {
  const char* code;
  const char* meaning;
};

inline constexpr std::array<ExitCode, 7> exit_codes = {{{"0", "finished"},
                                                        {"64", "usage"},
                                                        {"65", "bad input"},
                                                        {"70", "physics failed"},
                                                        {"74", "files"},
                                                        {"75", "stopped (run again to go on)"},
                                                        {"76", "a newer attempt has taken over"}}};

inline constexpr const char* program_summary =
    "runs red blood cells in a channel, from a run file; stopped or killed, the same command resumes";

inline constexpr const char* how_a_run_ends =
    "A run writes into the folder of its run file. Ctrl-C, SIGTERM, SIGUSR2 or a file named `stop` there end it\n"
    "behind a checkpoint.\n";

/// All options but --complete, which is for shells.
boost::program_options::options_description program_options();

/// The same, taken apart.
struct OptionEntry {
  std::string name;        ///< "--ranks"
  std::string value_name;  ///< "AxBxC", "text|json"; "" for a switch
  std::string meaning;
};
std::vector<OptionEntry> option_entries();

/// Command lines with their meaning, a line each.
std::string command_examples();

/// The answer to --help: an example first, then every option.
std::string help_text();

}  // namespace rouleau
