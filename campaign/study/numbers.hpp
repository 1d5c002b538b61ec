// SPDX-License-Identifier: BSD-3-Clause
// Numbers as people write them in a study file, and ranges of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rouleau::campaign {

/// A decimal number or a fraction ("4.75", "1e-3", "1/3"), finite; nothing else around it.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The shortest decimal text that reads back to the same double.
[[nodiscard]] std::string shortest(double value);

/// The values of "from:to:step", end included within 1e-9 steps. Value i is from + i step in one rounding, not a
/// running sum; when all three are decimals it is the decimal number that a person would write (0:1:0.1 holds 0.3).
/// throws std::invalid_argument saying what is wrong
[[nodiscard]] std::vector<std::string> expand_range(std::string_view from, std::string_view to, std::string_view step);

}  // namespace rouleau::campaign
