// SPDX-License-Identifier: BSD-3-Clause
// Entities, UTF-8 and percent signs.
#include "report/markup.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace rouleau::campaign {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

unsigned char byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// The length of the character that begins at `i`, or 0 if there is no well-formed one that HTML allows.
std::size_t length_of_character(std::string_view text, std::size_t i) {
  const unsigned char first = byte(text, i);
  if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\n' || first == '\t' ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || i + length > text.size()) return 0;
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(text, i + k) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(text, i + k) & 0x3f);
  }
  const std::uint32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  const bool is_control = code < 0xa0, is_surrogate = code >= 0xd800 && code < 0xe000;
  const bool is_no_character = (code & 0xfffe) == 0xfffe || (code >= 0xfdd0 && code < 0xfdf0);
  return code < least || code > 0x10ffff || is_control || is_surrogate || is_no_character ? 0 : length;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    switch (text[i]) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\r':  // of a line end; alone it is one
        out += i + 1 < text.size() && text[i + 1] == '\n' ? "" : "\n";
        break;
      default:
        out += length == 0 ? replacement : text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return out;
}

std::string link_to(std::string_view relative_path) {
  std::string out;
  for (const char c : relative_path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("-._~/").find(c) != std::string_view::npos;
    if (is_plain)
      out += c;
    else
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace rouleau::campaign
