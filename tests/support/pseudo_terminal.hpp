// SPDX-License-Identifier: BSD-3-Clause
// A program in a pseudo-terminal, and what a user would see there: a small interpreter of the control sequences that
// our programs write. Any other one fails the test.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rouleau::testing {

/// A screen of characters (of UTF-8), with the second screen that full-screen programs borrow.
class TerminalPicture {
 public:
  TerminalPicture(int columns, int rows) : columns_(columns), lines_(static_cast<std::size_t>(rows)) {}

  void resize(int columns, int rows) {
    columns_ = columns;
    lines_.resize(static_cast<std::size_t>(rows));
  }

  void write(const std::string& bytes) {
    for (const char c : bytes) {
      if (!sequence_.empty()) {
        sequence_ += c;
        if (sequence_.size() > 2 && c >= '@' && c <= '~') obey();
      } else if (c == '\033') {
        sequence_ = c;
      } else if (c == '\r') {
        column_ = 0;
      } else if (c == '\n') {
        next_line();
      } else {
        put(c);
      }
    }
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> texts;
    for (const auto& line : lines_) {
      std::string text;
      for (const std::string& cell : line) text += cell.empty() ? " " : cell;
      text.erase(text.find_last_not_of(' ') + 1);
      texts.push_back(text);
    }
    return texts;
  }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const std::string& line : lines()) all += line + "\n";
    return all;
  }

  bool is_second = false, cursor_is_shown = true, wraps = true;
  /// A picture that begins in the corner is whole when the rest below it was cleared: it may arrive in pieces.
  bool is_whole = true;
  int overflows = 0;  ///< characters of the last picture that found no room in their line
  int colours = 0;    ///< changes of colour
  int second_screens = 0;

 private:
  void put(char c) {
    const bool continues = (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    if (continues) {
      if (last_ != nullptr) *last_ += c;
      return;
    }
    if (column_ >= columns_) {
      ++overflows;
      last_ = nullptr;
      return;
    }
    auto& line = lines_.at(static_cast<std::size_t>(row_));
    line.resize(std::max(line.size(), static_cast<std::size_t>(column_) + 1));
    last_ = &line[static_cast<std::size_t>(column_++)];
    *last_ = std::string(1, c);
  }
  void next_line() {
    if (row_ + 1 < static_cast<int>(lines_.size())) {
      ++row_;
      return;
    }
    lines_.erase(lines_.begin());
    lines_.emplace_back();
  }
  void obey() {
    const std::string what = std::exchange(sequence_, "");
    auto& line = lines_.at(static_cast<std::size_t>(row_));
    // Behind the last character of a full line the cursor still stands on it.
    const auto cursor = static_cast<std::size_t>(std::min(column_, columns_ - 1));
    if (what == "\033[K") {
      line.resize(std::min(line.size(), cursor));
    } else if (what == "\033[J") {
      line.resize(std::min(line.size(), cursor));
      for (std::size_t below = static_cast<std::size_t>(row_) + 1; below < lines_.size(); ++below)
        lines_[below].clear();
      is_whole = true;
    } else if (what == "\033[H") {
      row_ = column_ = overflows = 0;
      is_whole = false;
    } else if (what == "\033[?1049h" || what == "\033[?1049l") {
      take_screen(what.back() == 'h');
    } else if (what == "\033[?25h" || what == "\033[?25l") {
      cursor_is_shown = what.back() == 'h';
    } else if (what == "\033[?7h" || what == "\033[?7l") {
      wraps = what.back() == 'h';
    } else if (what.back() == 'm') {
      ++colours;
    } else {
      ADD_FAILURE() << "a control sequence that nobody expects: ESC" << what.substr(1);
    }
  }
  void take_screen(bool second) {
    if (second == is_second) return;
    second_screens += second ? 1 : 0;
    std::swap(lines_, other_lines_);
    std::swap(row_, other_row_);
    std::swap(column_, other_column_);
    if (second) row_ = column_ = 0;
    lines_.resize(std::max(lines_.size(), other_lines_.size()));
    if (second) lines_.assign(other_lines_.size(), {});
    is_second = second;
  }

  int columns_, row_ = 0, column_ = 0, other_row_ = 0, other_column_ = 0;
  std::vector<std::vector<std::string>> lines_, other_lines_;
  std::string* last_ = nullptr;
  std::string sequence_;
};

/// The program and its terminal. The environment is this process's, changed by `environment` ("" = unset).
class PseudoTerminal {
 public:
  PseudoTerminal(const std::vector<std::string>& words, int columns, int rows,
                 const std::map<std::string, std::string>& environment = {})
      : picture(columns, rows) {
    const winsize size{static_cast<unsigned short>(rows), static_cast<unsigned short>(columns), 0, 0};
    pid_ = ::forkpty(&fd_, nullptr, nullptr, &size);
    if (pid_ != 0) return;
    ::setenv("TERM", "xterm-256color", 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    ::unsetenv("NO_COLOR");
    for (const auto& [name, value] : environment)
      value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::_exit(98);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() {
    if (!has_ended_) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(fd_);
  }

  [[nodiscard]] pid_t pid() const { return pid_; }
  void type(const std::string& keys) const { EXPECT_EQ(::write(fd_, keys.data(), keys.size()), std::ssize(keys)); }
  void resize(int columns, int rows) {
    picture.resize(columns, rows);
    const winsize size{static_cast<unsigned short>(rows), static_cast<unsigned short>(columns), 0, 0};
    EXPECT_EQ(::ioctl(fd_, TIOCSWINSZ, &size), 0);  // sends SIGWINCH
  }

  /// Reads what the program writes until the picture is whole and as wanted.   returns false when it was not within a
  /// minute, or when the program has closed the terminal before
  bool shows(const std::function<bool(const TerminalPicture&)>& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    const auto is_there = [&] { return picture.is_whole && wanted(picture); };
    while (!is_there()) {
      if (std::chrono::steady_clock::now() > deadline || !read_some()) return is_there();
    }
    return true;
  }
  bool shows(const std::string& text) {
    return shows([&](const TerminalPicture& p) { return p.text().find(text) != std::string::npos; });
  }
  /// Reads to the end.   returns the exit code; 1000 + signal if a signal ended it
  int end() {
    while (read_some()) {
    }
    int status = 0;
    ::waitpid(pid_, &status, 0);
    has_ended_ = true;
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
  }

  TerminalPicture picture;
  std::string written;  ///< all bytes

 private:
  bool read_some() {
    pollfd waiting{fd_, POLLIN, 0};
    if (::poll(&waiting, 1, 100) == 0) return true;
    char buffer[256];  // in pieces, as on a slow line
    const ssize_t count = ::read(fd_, buffer, sizeof buffer);
    if (count <= 0) return false;  // the program has closed the other side
    const std::string bytes(buffer, static_cast<std::size_t>(count));
    written += bytes;
    picture.write(bytes);
    return true;
  }

  int fd_ = -1;
  pid_t pid_ = -1;
  bool has_ended_ = false;
};

}  // namespace rouleau::testing
