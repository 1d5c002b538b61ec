// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing numbers without loss, and ranges without accumulated rounding.
#include "study/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace rouleau::campaign {

namespace {

constexpr double end_tolerance_steps = 1e-9;
constexpr double most_values = 100000;
constexpr int most_decimals = 9;         // so that scaled numbers stay exact in a double
constexpr double largest_scaled = 1e15;  // below 2^53

std::optional<double> parse_decimal(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Digits behind the point of a plain decimal ("4.25" -> 2), or nothing for exponents and fractions.
std::optional<int> decimals(std::string_view text) {
  const std::size_t point = text.find('.');
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_sign = i == 0 && (text[i] == '+' || text[i] == '-');
    if (!is_sign && i != point && (text[i] < '0' || text[i] > '9')) return std::nullopt;
  }
  return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

/// The power of ten that makes all three whole numbers, or 0 if there is none of use.
double common_scale(std::string_view from, std::string_view to, std::string_view step) {
  int digits = 0;
  for (const std::string_view text : {from, to, step}) {
    const std::optional<int> here = decimals(text);
    if (!here || *here > most_decimals) return 0;
    digits = std::max(digits, *here);
  }
  return std::pow(10.0, digits);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text);
  const auto top = parse_decimal(text.substr(0, slash));
  const auto bottom = parse_decimal(text.substr(slash + 1));
  if (!top || !bottom || *bottom == 0) return std::nullopt;
  return *top / *bottom;
}

std::string shortest(double value) { return fmt::format("{}", value); }

std::vector<std::string> expand_range(std::string_view from, std::string_view to, std::string_view step) {
  const auto a = parse_number(from);
  const auto b = parse_number(to);
  const auto h = parse_number(step);
  for (const auto& [number, text] : {std::pair{a, from}, std::pair{b, to}, std::pair{h, step}}) {
    if (!number) throw std::invalid_argument(fmt::format("`{}` is not a number", text));
  }
  if (*h == 0) throw std::invalid_argument("the step is 0");
  const double steps = (*b - *a) / *h;
  if (steps < -end_tolerance_steps) {
    throw std::invalid_argument(fmt::format("the step {} leads away from {}", step, to));
  }
  if (steps >= most_values) {
    throw std::invalid_argument(fmt::format("it has more than {:.0f} values", most_values));
  }
  const auto last = static_cast<std::int64_t>(std::floor(steps + end_tolerance_steps));
  double scale = common_scale(from, to, step);
  if (scale * std::max({std::abs(*a), std::abs(*b), std::abs(*h)}) > largest_scaled) scale = 0;

  std::vector<std::string> values;
  for (std::int64_t i = 0; i <= last; ++i) {
    // Whole multiples of 10^-n, divided once: the correctly rounded double of the decimal.
    const double value = scale > 0 ? (std::round(*a * scale) + static_cast<double>(i) * std::round(*h * scale)) / scale
                                   : *a + static_cast<double>(i) * *h;
    values.push_back(shortest(value == 0 ? 0.0 : value));
  }
  return values;
}

}  // namespace rouleau::campaign
