// SPDX-License-Identifier: BSD-3-Clause
// Lines of points that fit a terminal: which columns there is room for, and how they look. Pure.
#pragma once

#include <string>
#include <vector>

#include "commands/watch_facts.hpp"

namespace rouleau::campaign {

/// What the terminal can show and the user wants to see.
struct Look {
  int columns = 80, rows = 24;
  bool colour = false;
  bool utf8 = false;   ///< blocks and Greek letters; else ASCII alone
  bool header = true;  ///< titles over the columns
  std::string hint;    ///< for the corner: how to leave
};

/// How much a point asks for attention; this is also the order when not all can be shown.
enum class Standing { running, trouble, queued, unfinished, finished };
[[nodiscard]] Standing standing_of(const PointStatus& status);

/// A colour that says the same as the words it is for.
enum class Tint { none, running, trouble, finished, faint };

/// A line in the making: what finds no room any more is cut.
class FittedLine {
 public:
  explicit FittedLine(const Look& look) : room_(static_cast<std::size_t>(look.columns)), colour_(look.colour) {}
  FittedLine& add(const std::string& piece, Tint tint = Tint::none);
  [[nodiscard]] std::size_t room() const { return room_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t room_;
  bool colour_;
};

/// "#####....." of so many characters, or blocks.
[[nodiscard]] std::string bar_text(double fraction, std::size_t width, bool utf8);

/// The titles and a line for each of the points. Point and state are always there; the others are left out when there
/// is no room for them, the least important first. A note without a column of its own takes the place of the columns
/// that mean nothing for a point that does not run.
[[nodiscard]] std::vector<std::string> table_lines(const WatchFacts& facts,
                                                   const std::vector<const PointStatus*>& shown, const Look& look);

}  // namespace rouleau::campaign
