// SPDX-License-Identifier: BSD-3-Clause
// Options of rouleau-solver, and the help that is made of the tables.
#include "run/command_table.hpp"

#include <fmt/format.h>

#include <boost/program_options.hpp>
#include <sstream>

namespace rouleau {

namespace po = boost::program_options;

po::options_description program_options() {
  po::options_description options("Options", 100, 60);
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  options.add_options()                                                                                               //
      ("attempt", po::value<int>()->value_name("N"), "number of the attempt that a manager has made (with --token)")  //
      ("token", text("TEXT"), "its token; without both the next attempt is claimed")                                  //
      ("deadline-s", po::value<double>()->value_name("S"),
       "stop behind a checkpoint before this many seconds have passed")                     //
      ("ranks", text("AxBxC"), "cut of the lattice, such as 1x2x2; default: the cheapest")  //
      ("quiet", "no conversion table, no progress lines")                                   //
      ("format", text("text|json"), "of check and inspect; default: text")                  //
      ("slice", text("y|z"), "of shape: with the flags of that slice through the cell")     //
      ("help", "this text")                                                                 //
      ("help-run-file", "every parameter of a run file, as a run file")                     //
      ("man", "this text as a man page: rouleau-solver --man | man -l -")                   //
      ("man-run-file", "the parameters of a run file as a man page")                        //
      ("version", "version, git hash, compiler, libraries");
  return options;
}

std::vector<OptionEntry> option_entries() {
  std::vector<OptionEntry> entries;
  const po::options_description options = program_options();
  for (const auto& option : options.options())
    entries.push_back({"--" + option->long_name(),
                       option->semantic()->max_tokens() == 0 ? "" : option->semantic()->name(), option->description()});
  return entries;
}

std::string command_examples() {
  std::string text =
      "  rouleau-solver run.ini                    one core\n"
      "  mpirun -n 4 rouleau-solver run.ini        four; the same bits\n";
  for (const Question& question : questions)
    text += fmt::format("  {:<40}  {}\n", fmt::format("rouleau-solver {} {}", question.word, question.file),
                        question.meaning);
  return text + "  rouleau-solver --help-run-file > run.ini  a run file to start from\n";
}

std::string help_text() {
  std::ostringstream text;
  text << "rouleau-solver: " << program_summary << "\n\n"
       << command_examples() << '\n'
       << how_a_run_ends << '\n'
       << program_options() << "\nExit codes:\n";
  for (const ExitCode& code : exit_codes) text << fmt::format("  {:<3} {}\n", code.code, code.meaning);
  return text.str();
}

}  // namespace rouleau
