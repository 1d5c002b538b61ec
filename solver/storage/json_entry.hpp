// SPDX-License-Identifier: BSD-3-Clause
// A JSON value as the type that is wanted and nothing else.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace rouleau {

/// The library itself would turn 1.5, 1e300 and `true` into integers in silence.
/// throws std::invalid_argument, or an exception of the JSON library
template <class T>
[[nodiscard]] T strictly(const nlohmann::ordered_json& value) {
  if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    const bool fits = value.is_number_unsigned()
                          ? std::in_range<T>(value.get<std::uint64_t>())
                          : value.is_number_integer() && std::in_range<T>(value.get<std::int64_t>());
    if (!fits) throw std::invalid_argument(fmt::format("{} is not a whole number of its range", value.dump()));
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!value.is_number()) throw std::invalid_argument(fmt::format("{} is not a number", value.dump()));
  }
  return value.get<T>();
}

}  // namespace rouleau
