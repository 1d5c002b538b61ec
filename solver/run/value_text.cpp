// SPDX-License-Identifier: BSD-3-Clause
#include "run/value_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace rouleau {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

double parse_plain(std::string_view text) {
  if (text.find(',') != std::string_view::npos) throw std::invalid_argument("is not a number (write a decimal point)");
  text = without_plus(trimmed(text));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range)
    throw std::invalid_argument("is too large or too small for a double-precision number");
  if (error != std::errc{} || end != text.data() + text.size()) throw std::invalid_argument("is not a number");
  if (!std::isfinite(value)) throw std::invalid_argument("is not finite");
  return value;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

double parse_real(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return parse_plain(text);
  const double denominator = parse_plain(text.substr(slash + 1));
  if (denominator == 0) throw std::invalid_argument("divides by zero");
  const double value = parse_plain(text.substr(0, slash)) / denominator;
  if (!std::isfinite(value)) throw std::invalid_argument("is not finite");
  return value;
}

std::int64_t parse_integer(std::string_view text) {
  text = without_plus(trimmed(text));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) throw std::invalid_argument("is too large for a whole number");
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument("is not a whole number in decimal digits");
  return value;
}

Vec3 parse_vector(std::string_view text) {
  Vec3 value;
  text = trimmed(text);
  for (int i = 0; i < 3; ++i) {
    if (text.empty()) throw std::invalid_argument("is not three numbers separated by blanks");
    const auto end = std::min(text.find_first_of(" \t"), text.size());
    value[i] = parse_real(text.substr(0, end));
    text = trimmed(text.substr(end));
  }
  if (!text.empty()) throw std::invalid_argument("is not three numbers separated by blanks");
  return value;
}

std::string canonical(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0);  // -0 + 0 = 0
  return {buffer, result.ptr};
}

std::string canonical(const Vec3& value) {
  return canonical(value[0]) + " " + canonical(value[1]) + " " + canonical(value[2]);
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;  // a third of the letters wrong at most
  for (const auto& candidate : candidates) {
    // A name without its unit (`end_time`) is the likeliest slip of all.
    const bool prefix = word.size() >= 4 && candidate.starts_with(word);
    const std::size_t distance = prefix ? 1 : edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace rouleau
