// SPDX-License-Identifier: BSD-3-Clause
// Text and numbers as gnuplot reads them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rouleau::campaign {

/// `text` in single quotes, in which gnuplot expands neither backquotes, macros nor backslashes. A quote becomes an
/// apostrophe (U+2019): gnuplot 5.4 misreads a string that begins with a doubled one. Line ends and other control
/// characters become blanks.
[[nodiscard]] std::string gnuplot_quoted(std::string_view text);

/// A comment line: one line, whatever `text` holds.
[[nodiscard]] std::string gnuplot_comment(std::string_view text);

/// Seven significant digits; NaN, which gnuplot leaves out, for none or one that is not finite.
[[nodiscard]] std::string gnuplot_number(const std::optional<double>& value);

}  // namespace rouleau::campaign
