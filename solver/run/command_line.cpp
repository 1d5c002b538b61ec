// SPDX-License-Identifier: BSD-3-Clause
#include "run/command_line.hpp"

#include <boost/program_options.hpp>
#include <charconv>
#include <string_view>

#include "run/stop.hpp"

namespace rouleau {

namespace po = boost::program_options;

namespace {

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
    const auto seconds = given["deadline-s"].as<double>();
    if (!(seconds > 0)) fail(Exit::usage, "--deadline-s {}: a positive number of seconds is needed.", seconds);
    run.deadline = monotonic_s() + seconds;  // before MPI starts, which takes its time
  }
  if (given.count("ranks")) run.ranks = parse_ranks(given["ranks"].as<std::string>());
  run.quiet = given.count("quiet") > 0;
}

Verb verb_of(std::vector<std::string>& words) {
  if (words.empty()) fail(Exit::usage, "a run file is missing: rouleau-solver run.ini (see --help).");
  Verb verb = Verb::run;
  for (const Question& question : questions)
    if (words[0] == question.word) verb = question.verb;
  if (verb != Verb::run) words.erase(words.begin());
  if (words.size() != 1)
    fail(Exit::usage,
         "one file is needed, {} are given: rouleau-solver [check|inspect|verify|shape] FILE (see --help).",
         words.size());
  return verb;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) try {
  CommandLine line;
  if (argc > 1 && std::string_view(argv[1]) == "--complete") {
    line.verb = Verb::complete;
    line.words.assign(argv + 2, argv + argc);
    return line;
  }
  po::options_description all;
  all.add(program_options()).add_options()("word", po::value<std::vector<std::string>>());
  po::positional_options_description positions;
  positions.add("word", -1);
  po::variables_map given;
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(), given);
  if (given.count("help")) line.verb = Verb::help;
  if (given.count("help-run-file")) line.verb = Verb::help_run_file;
  if (given.count("man")) line.verb = Verb::manual;
  if (given.count("man-run-file")) line.verb = Verb::manual_of_run_file;
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

}  // namespace rouleau
