// SPDX-License-Identifier: BSD-3-Clause
// Pages in the macros of man(7), which groff and mandoc read.
#include "run/manual.hpp"

#include <fmt/format.h>

#include <sstream>

#include "run/command_table.hpp"
#include "run/parameter_table.hpp"
#include "run/version.hpp"

namespace rouleau {

namespace {

/// A line of text: nothing of it is taken for a command, and it can be copied from the page as it was.
std::string escaped(const std::string& line) {
  std::string text = line.starts_with('.') ? "\\&" : "";
  for (const char c : line) {
    if (c == '\\')
      text += "\\e";
    else if (c == '-')
      text += "\\-";
    else if (c == '\'')
      text += "\\(aq";
    else if (c == '`')
      text += "\\(ga";
    else if (c == '^')
      text += "\\(ha";
    else if (c == '~')
      text += "\\(ti";
    else
      text += c;
  }
  return text + '\n';
}

std::string bold(const std::string& text) { return ".B " + escaped(text); }

std::string item(const std::string& word, const std::string& meaning) {
  return ".TP\n" + bold(word) + escaped(meaning);
}

/// Lines that stay as they are.
std::string kept(const std::string& lines) {
  std::string text = ".EX\n";
  std::istringstream rest(lines);
  for (std::string line; std::getline(rest, line);) text += escaped(line);
  return text + ".EE\n";
}

/// Without a date, which would change from build to build.
std::string heading(const char* name, int section, const std::string& summary) {
  return fmt::format(".TH {} {} \"\" \"rouleau {}\"\n.SH NAME\n", name, section, version()) +
         escaped(fmt::format("{} - {}", name, summary));
}

}  // namespace

std::string manual_page() {
  std::string page = heading("rouleau-solver", 1, program_summary);
  page += ".SH SYNOPSIS\n" + bold("rouleau-solver run.ini [options]") + ".SH EXAMPLES\n" + kept(command_examples());
  page += ".SH DESCRIPTION\n" + kept(how_a_run_ends) + ".SH OPTIONS\n";
  for (const OptionEntry& option : option_entries())
    page += item(option.name + (option.value_name.empty() ? "" : " " + option.value_name), option.meaning);
  page += ".SH EXIT STATUS\n";
  for (const ExitCode& code : exit_codes) page += item(code.code, code.meaning);
  return page + ".SH SEE ALSO\n" + escaped("rouleau(1), rouleau-run-file(5)");
}

std::string manual_page_of_run_file() {
  return heading("rouleau-run-file", 5, "the parameters of a run of rouleau-solver, and of each point of a study") +
         ".SH DESCRIPTION\n" + kept(example_run_file()) + ".SH SEE ALSO\n" +
         escaped("rouleau-solver(1), rouleau-study(5)");
}

}  // namespace rouleau
