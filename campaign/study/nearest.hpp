// SPDX-License-Identifier: BSD-3-Clause
// Suggestions for names that were mistyped.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rouleau::campaign {

/// The candidate nearest to `word` by edit distance, or "" if none is near enough to be meant.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// " Did you mean `x`?" or "", to be put behind an error.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace rouleau::campaign
