// SPDX-License-Identifier: BSD-3-Clause
// Checksums that do not depend on how an array is cut over ranks.
//
// The checksum of an array is the sum modulo 2^64 of mix(i, bits of element i) over all its elements, i the global
// index. Ranks sum what they own and the sums add up exactly, in any order. mix is a bijection of the bits for a fixed
// index, so a change of any one element is always noticed. Elements that change places, or many that change at once (a
// lost page of zeros), change a sum of well mixed terms and are missed once in 2^64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/grid.hpp"
#include "parallel/communicator.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// The finaliser of SplitMix64 [Steele2014] on an index and 64 bits.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t index, std::uint64_t bits) {
  std::uint64_t z = bits + (index + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// A block of one component in memory: `first` is its node of lowest coordinates, strides in elements.
struct BlockView {
  ElementType type;
  const void* first;
  std::ptrdiff_t stride_y, stride_z;
};

[[nodiscard]] BlockView view(const LatticeItem& item, std::size_t component);

/// This block's part of the checksum of a component.
[[nodiscard]] std::uint64_t block_checksum(const BlockView& values, const Lattice& lattice, const Block& block);

/// Checksum of `count` elements in a row that start at global index `first`.
[[nodiscard]] std::uint64_t row_checksum(ElementType type, const void* elements, std::size_t count,
                                         std::uint64_t first);

/// Adds up the ranks' parts modulo 2^64, in place. Collective.
void sum_over_ranks(const Communicator& comm, std::vector<std::uint64_t>& parts);

/// XXH3-64 of a text's bytes, and 128 bits as 32 hex digits.
[[nodiscard]] std::uint64_t text_checksum(std::string_view text);
[[nodiscard]] std::string text_digest(std::string_view text);

/// 16 lower-case hex digits, and back; no value for anything else.
[[nodiscard]] std::string hex(std::uint64_t value);
[[nodiscard]] bool parse_hex(std::string_view text, std::uint64_t& value);

}  // namespace rouleau
