// SPDX-License-Identifier: BSD-3-Clause
// How much was damaged, and what came of it: one line of JSON at the end.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>

namespace rouleau::testing {

struct Figures {
  long damage_positions = 0;
  long undetected = 0;     ///< damage that was taken for sound
  long wrong_resumes = 0;  ///< runs that ended otherwise than the undisturbed one
};

/// Of this program, printed when it ends.
Figures& figures();

/// `some` places in the short form, `many` with SOAK set.
inline int places(int some, int many) { return std::getenv("SOAK") == nullptr ? some : many; }

/// Place number i in [0, size), spread evenly whatever the count: multiples of the golden ratio.
[[nodiscard]] std::size_t spread(int i, std::size_t size);

/// The bytes with one damage at a place. Kinds: a flipped bit (3 of 5), an end, a page of zeros.
[[nodiscard]] std::string damaged(const std::string& sound, std::size_t place, int i);

}  // namespace rouleau::testing
