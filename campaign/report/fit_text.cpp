// SPDX-License-Identifier: BSD-3-Clause
// Cutting, filling and folding by characters of UTF-8.
#include "report/fit_text.hpp"

#include <algorithm>
#include <sstream>

namespace rouleau::campaign {

namespace {

constexpr std::string_view cut_mark = "...";

/// Continuation bytes of UTF-8 take no place of their own.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

/// Control characters of ASCII, and those of Latin-1 as UTF-8 writes them (0xc2 0x80 to 0xc2 0x9f), become blanks.
std::string without_controls(std::string_view text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    const bool is_long_control = byte == 0xc2 && next >= 0x80 && next < 0xa0;
    clean += byte < 0x20 || byte == 0x7f || is_long_control ? ' ' : text[i];
    if (is_long_control) ++i;
  }
  return clean;
}

}  // namespace

std::size_t shown_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string fitted(std::string_view text, std::size_t width) {
  std::string clean = without_controls(text);
  if (shown_width(clean) <= width) return clean;
  const std::size_t mark = std::min(width, cut_mark.size());
  std::size_t bytes = 0;
  for (std::size_t kept = 0; bytes < clean.size(); ++bytes) {
    if (begins_character(clean[bytes]) && kept++ == width - mark) break;
  }
  return clean.substr(0, bytes) + std::string(cut_mark.substr(0, mark));
}

std::string filled(const std::string& text, std::size_t width, bool to_the_right) {
  const std::string blanks(width - std::min(width, shown_width(text)), ' ');
  return to_the_right ? blanks + text : text + blanks;
}

std::string folded(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string result, word;
  std::size_t used = 0;
  while (words >> word) {
    const std::size_t length = shown_width(word);
    const bool fits = used == 0 || used + 1 + length <= width;
    if (used != 0) result += fits ? " " : "\n" + std::string(indent, ' ');
    result += word;
    used = fits && used != 0 ? used + 1 + length : length;
  }
  return result;
}

}  // namespace rouleau::campaign
