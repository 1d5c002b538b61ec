// SPDX-License-Identifier: BSD-3-Clause
// The terminal's second screen, drawn over and over in place; the first one comes back untouched.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace rouleau::campaign {

struct ScreenSize {
  int columns = 80, rows = 24;
};

/// Takes the screen when the first picture is shown and gives it back when it dies.
class Screen {
 public:
  explicit Screen(std::ostream& out) : out_(out) {}
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() { leave(); }

  /// Draws the lines from the top, each over what was there.
  void show(const std::vector<std::string>& lines);
  /// Gives the screen back, until the next picture.
  void leave();

  /// Of stdout's terminal at this moment; 80 x 24 if it does not say.
  [[nodiscard]] static ScreenSize size();

 private:
  std::ostream& out_;
  bool is_taken_ = false;
};

/// Whether the user's locale asks for UTF-8.
[[nodiscard]] bool locale_is_utf8();

}  // namespace rouleau::campaign
