// SPDX-License-Identifier: BSD-3-Clause
// How many digits of a number a reader gets to see: as many as its error allows.
#pragma once

#include <optional>
#include <string>

namespace rouleau::campaign {

/// Four significant digits; a number that has six or fewer of its own, as inputs do (4.8125), is kept as it is.
[[nodiscard]] std::string short_number(double value);

/// "0.208(40)" for 0.208451 and 0.040431: the brackets hold two digits of the error, which stand for the last two of
/// the value; "12.3(1.5)" where the error has a digit before the point. An error of zero or of round-off is "(0)";
/// without an error it is short_number().
[[nodiscard]] std::string in_brackets(double value, const std::optional<double>& error);

/// The decimals to which a value of that error is given: those of the error's two leading digits, 3 for 0.0404;
/// negative for an error of 100 and more. None without an error, or with one of round-off.
[[nodiscard]] std::optional<int> decimals_of(double value, const std::optional<double>& error);

/// The value to that many decimals (-1: to tens), never "-0.00".
[[nodiscard]] std::string to_decimals(double value, int decimals);

}  // namespace rouleau::campaign
