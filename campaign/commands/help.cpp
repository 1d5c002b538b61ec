// SPDX-License-Identifier: BSD-3-Clause
// Help as plain text: an example first, lines of 80 columns.
#include "commands/help.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>

#include "commands/option_list.hpp"
#include "report/fit_text.hpp"

namespace rouleau::campaign {

namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t widest_left = 30;  ///< a longer left side gets a line of its own

/// Words of `text` after a left column.
void print_item(std::ostream& out, const std::string& left, std::size_t left_width, const std::string& text) {
  const std::size_t indent = left_width + 4;
  if (left.size() > left_width)
    out << "  " << left << '\n' << std::string(indent, ' ');
  else
    out << "  " << filled(left, left_width + 2);
  out << folded(text, line_width - indent, indent) << '\n';
}

/// Paragraphs are filled; lines that begin with a blank stay as they are.
void print_paragraphs(std::ostream& out, const std::string& text) {
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out << folded(paragraph, line_width) << '\n';
    paragraph.clear();
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ') {
      paragraph += line + ' ';
      continue;
    }
    end_paragraph();
    out << line << '\n';
  }
  end_paragraph();
}

void print_options(std::ostream& out, const char* title, const std::vector<OptionEntry>& options) {
  if (options.empty()) return;
  std::vector<std::string> lefts;
  std::size_t left_width = 0;
  for (const OptionEntry& option : options) {
    lefts.push_back((option.short_name.empty() ? "    " : option.short_name + ", ") + option.usage());
    left_width = std::max(left_width, std::min(widest_left, lefts.back().size()));
  }
  out << '\n' << title << ":\n";
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string& text = options[i].default_text;
    print_item(out, lefts[i], left_width, options[i].meaning + (text.empty() ? "" : " (default: " + text + ")"));
  }
}

void print_meanings(std::ostream& out, const char* title, std::span<const Meaning> meanings) {
  std::size_t left_width = 0;
  for (const Meaning& entry : meanings) left_width = std::max(left_width, std::string_view(entry.word).size());
  out << '\n' << title << ":\n";
  for (const Meaning& entry : meanings) print_item(out, entry.word, left_width, entry.meaning);
}

}  // namespace

void print_overview(std::span<const Verb* const> verbs, std::ostream& out) {
  out << "rouleau: " << program_summary << "\n\nExamples:\n" << first_examples;
  std::vector<Meaning> meanings;
  for (const Verb* verb : verbs) meanings.push_back({verb->name, verb->summary});
  print_meanings(out, "Verbs (rouleau VERB --help tells more)", meanings);
  print_meanings(out, "Options", program_options);
  std::string codes;
  for (const Meaning& code : exit_codes)
    codes += fmt::format("{}{} {}", codes.empty() ? "" : ", ", code.word, code.meaning);
  out << "\nExit codes:\n";
  print_item(out, "", 0, codes);
  print_meanings(out, "Environment", environment);
}

void print_help(const Verb& verb, std::ostream& out) {
  out << "rouleau " << verb.name << ": " << verb.summary << "\n\nExamples:\n" << verb.examples;
  out << "\nUsage: rouleau " << verb.name << ' ' << verb.synopsis << '\n';
  if (*verb.notes != '\0') print_paragraphs(out, std::string("\n") + verb.notes);
  if (verb.words == Words::points) print_paragraphs(out, std::string("\n") + how_points_are_named);
  print_options(out, "Options", own_options(verb));
  print_options(out, "Options of every verb", common_options(verb));
}

}  // namespace rouleau::campaign
