// SPDX-License-Identifier: BSD-3-Clause
// Rounding by the error.
#include "report/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace rouleau::campaign {
namespace {

constexpr int digits_kept = 6;
/// Errors smaller than this share of their value come from rounding: the series is constant.
constexpr double round_off = 1e-9;

/// "4.0e-02" for 0.040431: rounded first, since 0.00996 has its digits where 0.010 has them.
std::string two_digits(double error) { return fmt::format("{:.1e}", error); }

long significant_digits(const std::string& number) {
  const std::string mantissa = number.substr(0, number.find('e'));
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string::npos) return 0;
  return std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

std::string short_number(double value) {
  const std::string shortest = fmt::format("{}", value);
  if (!std::isfinite(value) || significant_digits(shortest) <= digits_kept) return shortest;
  const double size = std::abs(value);
  return size >= 999.95 && size < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:#.4g}", value);
}

std::optional<int> decimals_of(double value, const std::optional<double>& error) {
  if (!error || !std::isfinite(*error) || *error <= round_off * std::abs(value)) return std::nullopt;
  const std::string text = two_digits(*error);
  return 1 - std::stoi(text.substr(text.find('e') + 1));
}

std::string to_decimals(double value, int decimals) {
  const double unit = std::pow(10.0, std::max(0, -decimals));
  const double rounded = decimals < 0 ? std::round(value / unit) * unit : value;
  const std::string text = fmt::format("{:.{}f}", rounded, std::max(0, decimals));
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return is_zero && text.starts_with('-') ? text.substr(1) : text;
}

std::string in_brackets(double value, const std::optional<double>& error) {
  if (!std::isfinite(value) || !error || !std::isfinite(*error) || *error < 0) return short_number(value);
  const std::optional<int> decimals = decimals_of(value, error);
  if (!decimals) return short_number(value) + "(0)";
  const double largest = std::max(std::abs(value), *error);
  if (largest < 1e-4 || largest >= 1e7) {
    const int exponent = static_cast<int>(std::floor(std::log10(largest)));
    const double unit = std::pow(10.0, exponent);
    return fmt::format("{}e{:+03d}", in_brackets(value / unit, *error / unit), exponent);
  }
  const std::string digits = two_digits(*error);
  const std::string brackets =
      *decimals > 1 ? fmt::format("{}{}", digits[0], digits[2]) : to_decimals(*error, *decimals);
  return fmt::format("{}({})", to_decimals(value, *decimals), brackets);
}

}  // namespace rouleau::campaign
