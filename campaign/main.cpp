// SPDX-License-Identifier: BSD-3-Clause
// `rouleau`: streams, terminal, verbs.
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include "commands/verbs.hpp"

namespace {

bool may_redraw(bool out_is_terminal) {
  const char* terminal = std::getenv("TERM");
  const bool is_dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return out_is_terminal && !is_dumb;
}

bool wants_colour() {
  const char* no_colour = std::getenv("NO_COLOR");
  return no_colour == nullptr || *no_colour == '\0';
}

int terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

int main(int count, char** words) {
  using namespace rouleau::campaign;
  const bool out_is_terminal = ::isatty(STDOUT_FILENO) == 1;
  const bool err_is_terminal = ::isatty(STDERR_FILENO) == 1;
  const bool redraws = may_redraw(out_is_terminal);
  Streams io{std::cout,        std::cerr, out_is_terminal, err_is_terminal, redraws && wants_colour(),
             terminal_width(), redraws};
  const int code = run_command_line(all_verbs, {words + 1, words + count}, io);
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "rouleau: cannot write to stdout. Check the disk's free space.\n";
    return static_cast<int>(Exit::failed);
  }
  return code;
}
