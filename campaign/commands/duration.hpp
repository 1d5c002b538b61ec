// SPDX-License-Identifier: BSD-3-Clause
// Lengths of time for eyes.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace rouleau::campaign {

/// "41 s", "3 min 10 s", "2 h 05 min", "4 d 07 h"
[[nodiscard]] inline std::string duration_text(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds < 0 ? 0 : seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {:02} h", s / 86400, s / 3600 % 24);
}

}  // namespace rouleau::campaign
