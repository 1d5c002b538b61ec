// SPDX-License-Identifier: BSD-3-Clause
// Walking through the words of a text file line by line, with errors that name the line.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace rouleau {

/// Yields the lines that are not empty, split at blanks; what follows '#' is a comment.
class TextLines {
 public:
  TextLines(std::string_view bytes, std::string_view name) : rest_(bytes), name_(name) {}

  /// Steps to the next line that holds a word; false at the end of the text.
  bool next() {
    words_.clear();
    while (words_.empty()) {
      if (rest_.empty()) return false;
      ++number_;
      const std::size_t end = rest_.find('\n');
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      line = line.substr(0, line.find('#'));
      split(line);
    }
    return true;
  }

  /// The same, where a line must follow: `what` says which one was expected.
  void expect(std::string_view what) {
    if (!next()) {
      fail(Exit::bad_input, "{}:{}: the file ends where {} should stand. Is it complete?", name_, number_, what);
    }
  }

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }

  /// Word i of the line as a finite number.
  [[nodiscard]] double number(std::size_t i) const {
    double value = 0;
    parse(i, value, "a number");
    if (!std::isfinite(value)) refuse(fmt::format("'{}' is not finite", words_[i]));
    return value;
  }

  /// Word i of the line as an integer in [0, limit).
  [[nodiscard]] std::int32_t index(std::size_t i, std::int64_t limit) const {
    std::int64_t value = 0;
    parse(i, value, "an integer");
    if (value < 0 || value >= limit) refuse(fmt::format("{} is outside 0..{}", value, limit - 1));
    return static_cast<std::int32_t>(value);
  }

  [[noreturn]] void refuse(const std::string& why) const { fail(Exit::bad_input, "{}:{}: {}.", name_, number_, why); }

 private:
  void split(std::string_view line) {
    constexpr std::string_view blanks = " \t\r\v\f";
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
      const std::size_t end = line.find_first_of(blanks, begin);
      words_.push_back(line.substr(begin, end - begin));
      begin = line.find_first_not_of(blanks, end);
    }
  }

  template <class T>
  void parse(std::size_t i, T& value, std::string_view what) const {
    std::string_view word = words_[i];
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);  // from_chars knows no plus
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) {
      refuse(fmt::format("'{}' is not {}, or out of its range", shortened(words_[i]), what));
    }
  }

  static std::string shortened(std::string_view word) {
    constexpr std::size_t longest = 40;
    return std::string(word.substr(0, longest)) + (word.size() > longest ? "..." : "");
  }

  std::string_view rest_, name_;
  std::size_t number_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace rouleau
