// SPDX-License-Identifier: BSD-3-Clause
// Values as text: strict reading of numbers, and the canonical form they are written in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"

namespace rouleau {

/// A number or a fraction of two (`1/3`), finite.
/// throws std::invalid_argument whose text completes a sentence that begins with the value: `is not a number`
double parse_real(std::string_view text);
/// A whole number in decimal digits; throws like parse_real.
std::int64_t parse_integer(std::string_view text);
/// Three numbers separated by blanks; throws like parse_real.
Vec3 parse_vector(std::string_view text);

/// The shortest text that reads back to the same double; -0 is 0.
std::string canonical(double value);
std::string canonical(const Vec3& value);

/// The candidate nearest to `word` by edit distance, or empty if none is near enough to be a slip of the pen.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace rouleau
