// SPDX-License-Identifier: BSD-3-Clause
#include "run/command_line.hpp"

#include <boost/program_options.hpp>
#include <charconv>
#include <sstream>

namespace rouleau {

namespace po = boost::program_options;

namespace {

po::options_description visible_options() {
  po::options_description options("Options", 100, 60);
  options.add_options()                                                                                     //
      ("attempt", po::value<int>(), "number of the attempt that a manager has made (with --token)")         //
      ("token", po::value<std::string>(), "its token; without both the next attempt is claimed")            //
      ("deadline-s", po::value<double>(), "stop behind a checkpoint before this many seconds have passed")  //
      ("ranks", po::value<std::string>(), "cut of the lattice, such as 1x2x2; default: the cheapest")       //
      ("quiet", "no conversion table, no progress lines")                                                   //
      ("format", po::value<std::string>(), "text (default) or json, for check and inspect")                 //
      ("slice", po::value<std::string>(), "y or z, for shape: the flags of that slice through the cell")    //
      ("help", "this text")                                                                                 //
      ("help-run-file", "every parameter of a run file, as a run file")                                     //
      ("version", "version, git hash, compiler, libraries");
  return options;
}

/// "1x2x2"
Int3 parse_ranks(const std::string& text) {
  Int3 ranks{0, 0, 0};
  const char* p = text.data();
  const char* const end = p + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(p, end, ranks[static_cast<std::size_t>(axis)]);
    const bool separated = axis == 2 ? next == end : next != end && *next == 'x';
    if (error != std::errc{} || !separated || ranks[static_cast<std::size_t>(axis)] < 1)
      fail(Exit::usage, "--ranks {}: three numbers of blocks along x, y and z are needed, such as 1x2x2.", text);
    p = next + 1;
  }
  return ranks;
}

void read_run_options(const po::variables_map& given, RunOptions& run) {
  if (given.count("attempt")) run.attempt = given["attempt"].as<int>();
  if (given.count("token")) run.token = given["token"].as<std::string>();
  if (run.attempt.has_value() == run.token.empty())
    fail(Exit::usage, "--attempt and --token belong together: give both, or neither to claim the next attempt.");
  if (run.attempt && *run.attempt < 1) fail(Exit::usage, "--attempt {}: attempts are numbered from 1.", *run.attempt);
  if (given.count("deadline-s")) {
    run.deadline_s = given["deadline-s"].as<double>();
    if (!(*run.deadline_s > 0))
      fail(Exit::usage, "--deadline-s {}: a positive number of seconds is needed.", *run.deadline_s);
  }
  if (given.count("ranks")) run.ranks = parse_ranks(given["ranks"].as<std::string>());
  run.quiet = given.count("quiet") > 0;
}

Verb verb_of(std::vector<std::string>& words) {
  if (words.empty()) fail(Exit::usage, "a run file is missing: rouleau-solver run.ini (see --help).");
  Verb verb = Verb::run;
  if (words[0] == "check") verb = Verb::check;
  if (words[0] == "inspect") verb = Verb::inspect;
  if (words[0] == "verify") verb = Verb::verify;
  if (words[0] == "shape") verb = Verb::shape;
  if (verb != Verb::run) words.erase(words.begin());
  if (words.size() != 1)
    fail(Exit::usage,
         "one file is needed, {} are given: rouleau-solver [check|inspect|verify|shape] FILE (see --help).",
         words.size());
  return verb;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) try {
  po::options_description all;
  all.add(visible_options()).add_options()("word", po::value<std::vector<std::string>>());
  po::positional_options_description positions;
  positions.add("word", -1);
  po::variables_map given;
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(), given);

  CommandLine line;
  if (given.count("help")) line.verb = Verb::help;
  if (given.count("help-run-file")) line.verb = Verb::help_run_file;
  if (given.count("version")) line.verb = Verb::version;
  if (line.verb != Verb::run) return line;

  auto words = given.count("word") ? given["word"].as<std::vector<std::string>>() : std::vector<std::string>{};
  line.verb = verb_of(words);
  line.file = line.run.run_file = words[0];
  if (given.count("format")) {
    const auto format = given["format"].as<std::string>();
    if (format != "text" && format != "json") fail(Exit::usage, "--format {}: text or json is possible.", format);
    line.json = format == "json";
    if (line.verb == Verb::run) fail(Exit::usage, "--format goes with check and inspect.");
  }
  if (given.count("slice")) {
    const auto axis = given["slice"].as<std::string>();
    if (axis != "y" && axis != "z") fail(Exit::usage, "--slice {}: y or z is possible.", axis);
    if (line.verb != Verb::shape) fail(Exit::usage, "--slice goes with shape.");
    line.slice_normal = axis == "y" ? 1 : 2;
  }
  read_run_options(given, line.run);
  return line;
} catch (const po::error& error) {
  throw Error(Exit::usage, std::string(error.what()) + " (see rouleau-solver --help).");
}

std::string help_text() {
  std::ostringstream text;
  text << "Runs red blood cells in a channel, from a run file; stopped or killed, the same command resumes.\n\n"
          "  rouleau-solver run.ini                    one core\n"
          "  mpirun -n 4 rouleau-solver run.ini        four; the same bits\n"
          "  rouleau-solver check run.ini              what would run: conversion table, cost, warnings\n"
          "  rouleau-solver inspect FILE.h5            what a checkpoint holds\n"
          "  rouleau-solver verify FILE.h5             whether it is whole\n"
          "  rouleau-solver shape FILE.h5              the cells of a checkpoint or snapshot, as JSON\n"
          "  rouleau-solver --help-run-file > run.ini  a run file to start from\n\n"
          "A run writes into the folder of its run file. Ctrl-C, SIGTERM, SIGUSR2 or a file named `stop` there end it "
          "behind a\n"
          "checkpoint.\n\n"
       << visible_options()
       << "\nExit codes: 0 finished, 64 usage, 65 bad input, 70 physics failed, 74 files, 75 stopped (run again to go "
          "on),\n"
          "76 a newer attempt has taken over.\n";
  return text.str();
}

}  // namespace rouleau
