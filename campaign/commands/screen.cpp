// SPDX-License-Identifier: BSD-3-Clause
// The few control sequences that it takes, which every terminal of the last forty years knows.
#include "commands/screen.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <ostream>

namespace rouleau::campaign {

namespace {

// The second screen, no cursor, and no wrapping: a line that is too long after all loses its end and moves nothing.
constexpr const char* take_screen = "\033[?1049h\033[?25l\033[?7l";
constexpr const char* give_screen_back = "\033[?7h\033[?25h\033[?1049l";
constexpr const char* home = "\033[H";
constexpr const char* clear_to_line_end = "\033[K";
constexpr const char* clear_below = "\033[J";

}  // namespace

void Screen::show(const std::vector<std::string>& lines) {
  // Nothing is cleared before it is written over, and all goes out at once: no flicker.
  std::string picture = is_taken_ ? home : std::string(take_screen) + home;
  for (std::size_t i = 0; i < lines.size(); ++i) picture += (i == 0 ? "" : "\r\n") + lines[i] + clear_to_line_end;
  out_ << picture << clear_below << std::flush;
  is_taken_ = true;
}

void Screen::leave() {
  if (is_taken_) out_ << give_screen_back << std::flush;
  is_taken_ = false;
}

ScreenSize Screen::size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

bool locale_is_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    return ::strcasestr(value, "utf-8") != nullptr || ::strcasestr(value, "utf8") != nullptr;
  }
  return false;
}

}  // namespace rouleau::campaign
