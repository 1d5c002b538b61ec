// SPDX-License-Identifier: BSD-3-Clause
// JSON records that vouch for themselves: the last entry, `check`, is over all bytes before it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "study/error.hpp"

namespace rouleau::campaign {

/// What is wrong with a record.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The text of a record (an object with entries), its check added (share/contract.md section 1).
[[nodiscard]] std::string record_text(const nlohmann::ordered_json& record);

/// Parses a record. One without a check is taken as it is: older versions wrote none.
/// throws Damage, or an exception of the JSON library
[[nodiscard]] nlohmann::json parse_record(const std::string& text);

/// An entry as a T and nothing else: the library itself would turn 1.5, 1e300 and `true` into integers in silence.
template <class T>
[[nodiscard]] T strictly(const nlohmann::json& value) {
  constexpr bool is_number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
  if constexpr (is_number && std::is_integral_v<T>) {
    const bool fits = value.is_number_unsigned()
                          ? std::in_range<T>(value.get<std::uint64_t>())
                          : value.is_number_integer() && std::in_range<T>(value.get<std::int64_t>());
    if (!fits) throw Damage(fmt::format("{} is not a whole number of its range", value.dump()));
  } else if constexpr (is_number) {
    constexpr T largest = 1e15;  // nothing that is recorded comes near
    if (!value.is_number() || !(value.get<T>() <= largest) || !(value.get<T>() >= -largest))
      throw Damage(fmt::format("{} is not a number of its range", value.dump()));
  }
  return value.get<T>();
}

/// Reads a record's text by `take`.   throws Error (damaged) "FILE: is damaged (why)" and the advice
template <class Take>
auto read_record(const std::string& text, const std::filesystem::path& file, std::string_view advice,
                 const Take& take) {
  const auto refuse = [&](const char* why) {
    fail(Exit::damaged, "{}: is damaged ({}){}", file.string(), why, advice);
  };
  try {
    return take(parse_record(text));
  } catch (const nlohmann::json::exception& error) {
    refuse(error.what());
  } catch (const Damage& damage) {
    refuse(damage.what());
  }
  throw std::logic_error("refuse() throws");
}

}  // namespace rouleau::campaign
