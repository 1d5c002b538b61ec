// SPDX-License-Identifier: BSD-3-Clause
// Text that is safe to show in a terminal and takes no more room than there is.
#pragma once

#include <string>
#include <string_view>

namespace rouleau::campaign {

/// The characters that a terminal shows of UTF-8 text.
[[nodiscard]] std::size_t shown_width(std::string_view text);

/// The text without control characters, which could move the cursor or recolour the screen, and in so many characters:
/// a longer one ends in "...".
[[nodiscard]] std::string fitted(std::string_view text, std::size_t width);

/// Filled up with blanks to the width, behind the text or before it.
[[nodiscard]] std::string filled(const std::string& text, std::size_t width, bool to_the_right = false);

/// Broken at blanks into lines of at most so many characters, all but the first behind `indent` blanks; a longer word
/// has a line of its own.
[[nodiscard]] std::string folded(const std::string& text, std::size_t width, std::size_t indent = 0);

}  // namespace rouleau::campaign
