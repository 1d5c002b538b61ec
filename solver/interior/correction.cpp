// SPDX-License-Identifier: BSD-3-Clause
#include "interior/correction.hpp"

#include <algorithm>

namespace rouleau {
namespace {

constexpr bool follows_table_1(int neighbours, int a, int d) {
  return thresholds(neighbours).fewest_to_stay == a && thresholds(neighbours).enough_to_join == d;
}
static_assert(follows_table_1(26, 8, 18), "inside");
static_assert(follows_table_1(17, 5, 12), "side");
static_assert(follows_table_1(11, 3, 8), "edge");
static_assert(follows_table_1(7, 2, 5), "corner");

/// The flag to come of a node with `active` inside neighbours.
constexpr std::uint8_t decide(std::uint8_t flag, int active, Thresholds limits) {
  return static_cast<std::uint8_t>(active >= (flag ? limits.fewest_to_stay : limits.enough_to_join));
}

}  // namespace

Correction::Correction(const Lattice& lattice, const Block& block)
    : lattice_(lattice),
      block_(block),
      corrected_(static_cast<std::size_t>(block.size[0]) * static_cast<std::size_t>(block.size[1]) *
                 static_cast<std::size_t>(block.size[2])),
      columns_(static_cast<std::size_t>(block.size[0]) + 2) {}

void Correction::correct_row(const Flags& flags, int j, int k, std::uint8_t* out) {
  const int size = block_.size[0];
  std::ranges::fill(columns_, std::uint8_t{0});
  int rows = 0;
  for (int c = -1; c <= 1; ++c)
    for (int b = -1; b <= 1; ++b) {
      if (!exists(2, k + c) || !exists(1, j + b)) continue;
      ++rows;
      const std::uint8_t* const row = &flags(-1, j + b, k + c);
      std::uint8_t* const column = columns_.data();
#pragma omp simd
      for (int i = 0; i < size + 2; ++i) column[i] = static_cast<std::uint8_t>(column[i] + row[i]);
    }
  if (!exists(0, -1)) columns_.front() = 0;
  if (!exists(0, size)) columns_.back() = 0;

  const std::uint8_t* const own = &flags(0, j, k);
  const std::uint8_t* const column = columns_.data();
  const auto active = [&](int i) { return column[i] + column[i + 1] + column[i + 2] - own[i]; };
  const Thresholds limits = thresholds(3 * rows - 1);
#pragma omp simd
  for (int i = 0; i < size; ++i) out[i] = decide(own[i], active(i), limits);
  for (const int i : {0, size - 1}) {
    const int across = 1 + exists(0, i - 1) + exists(0, i + 1);
    out[i] = decide(own[i], active(i), thresholds(across * rows - 1));
  }
}

Corrections Correction::apply(Flags& flags) {
  const Int3& size = block_.size;
  std::uint8_t* out = corrected_.data();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j, out += size[0]) correct_row(flags, j, k, out);

  Corrections changed;
  const std::uint8_t* next = corrected_.data();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j, next += size[0]) {
      std::uint8_t* const row = &flags(0, j, k);
      int activated = 0, deactivated = 0;
#pragma omp simd reduction(+ : activated, deactivated)
      for (int i = 0; i < size[0]; ++i) {
        activated += next[i] > row[i];
        deactivated += next[i] < row[i];
        row[i] = next[i];
      }
      changed.activated += activated;
      changed.deactivated += deactivated;
    }
  return changed;
}

}  // namespace rouleau
