// SPDX-License-Identifier: BSD-3-Clause
// Escapes of groff and mandoc.
#include "commands/roff.hpp"

#include <sstream>

namespace rouleau::campaign {

namespace {

std::string escaped(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {c};
  }
}

/// A line that begins with a dot or an apostrophe would be a command.
std::string guarded(std::string line) { return line.starts_with('.') ? "\\&" + line : line; }

}  // namespace

std::string roff_text(std::string_view text) {
  std::string line;
  bool is_bold = false;
  for (const char c : text) {
    if (c == '`') {
      is_bold = !is_bold;
      line += is_bold ? "\\fB" : "\\fR";
    } else {
      line += escaped(c);
    }
  }
  return guarded(line) + '\n';
}

std::string roff_lines(std::string_view lines) {
  std::string text = ".EX\n";
  std::istringstream rest{std::string(lines)};
  for (std::string line; std::getline(rest, line);) {
    std::string escapes;
    for (const char c : line) escapes += escaped(c);
    text += guarded(escapes) + '\n';
  }
  return text + ".EE\n";
}

std::string roff_paragraphs(std::string_view text) {
  std::string page, kept;
  std::istringstream rest{std::string(text)};
  for (std::string line; std::getline(rest, line);) {
    if (line.starts_with(' ')) {
      kept += line + '\n';
      continue;
    }
    if (!kept.empty()) page += roff_lines(kept);
    kept.clear();
    page += line.empty() ? ".PP\n" : roff_text(line);
  }
  return kept.empty() ? page : page + roff_lines(kept);
}

}  // namespace rouleau::campaign
