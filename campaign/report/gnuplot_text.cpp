// SPDX-License-Identifier: BSD-3-Clause
// Quotes, comments, digits.
#include "report/gnuplot_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rouleau::campaign {
namespace {

std::string one_line(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return out;
}

}  // namespace

std::string gnuplot_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : one_line(text)) {
    if (c == '\'')
      out += "\u2019";
    else
      out += c;
  }
  return out + "'";
}

std::string gnuplot_comment(std::string_view text) {
  std::string out = "# " + one_line(text);
  // A backslash at the end of a line would join the next one to the comment.
  while (out.ends_with('\\')) out += '.';
  return out + "\n";
}

std::string gnuplot_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.7g}", *value) : "NaN";
}

}  // namespace rouleau::campaign
