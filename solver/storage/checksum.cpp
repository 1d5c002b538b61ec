// SPDX-License-Identifier: BSD-3-Clause
// Order-free checksums of arrays, and hashes of texts.
#include "storage/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <bit>
#include <charconv>
#include <cstring>

namespace rouleau {
namespace {

// The bytes of a checkpoint are the bytes of memory; HDF5 files declare them little-endian.
static_assert(std::endian::native == std::endian::little, "checkpoints are written on little-endian machines only");

template <class Bits>
std::uint64_t sum_row(const std::byte* bytes, std::size_t count, std::uint64_t first) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Bits bits;
    std::memcpy(&bits, bytes + i * sizeof(Bits), sizeof(Bits));
    sum += mix(first + i, bits);
  }
  return sum;
}

}  // namespace

std::uint64_t row_checksum(ElementType type, const void* elements, std::size_t count, std::uint64_t first) {
  const auto* bytes = static_cast<const std::byte*>(elements);
  switch (element_size(type)) {
    case 1:
      return sum_row<std::uint8_t>(bytes, count, first);
    case 4:
      return sum_row<std::uint32_t>(bytes, count, first);
    default:
      return sum_row<std::uint64_t>(bytes, count, first);
  }
}

BlockView view(const LatticeItem& item, std::size_t component) {
  const Layout& layout = item.layout;
  const auto* bytes = static_cast<const std::byte*>(item.data[component]);
  const auto offset = layout.index(0, 0, 0) * static_cast<std::ptrdiff_t>(element_size(item.type));
  return {item.type, bytes + offset, layout.stride_y, layout.stride_z};
}

std::uint64_t block_checksum(const BlockView& values, const Lattice& lattice, const Block& block) {
  const auto size = static_cast<std::ptrdiff_t>(element_size(values.type));
  const auto* bytes = static_cast<const std::byte*>(values.first);
  const auto nx = static_cast<std::uint64_t>(lattice.size[0]);
  const auto ny = static_cast<std::uint64_t>(lattice.size[1]);
  std::uint64_t sum = 0;
  for (int k = 0; k < block.size[2]; ++k) {
    for (int j = 0; j < block.size[1]; ++j) {
      const auto z = static_cast<std::uint64_t>(block.begin[2] + k);
      const auto y = static_cast<std::uint64_t>(block.begin[1] + j);
      const auto x = static_cast<std::uint64_t>(block.begin[0]);
      const std::byte* row = bytes + (k * values.stride_z + j * values.stride_y) * size;
      sum += row_checksum(values.type, row, static_cast<std::size_t>(block.size[0]), (z * ny + y) * nx + x);
    }
  }
  return sum;
}

void sum_over_ranks(const Communicator& comm, std::vector<std::uint64_t>& parts) {
  // In halves of 32 bits, so that no signed sum can overflow.
  std::vector<std::int64_t> halves;
  halves.reserve(2 * parts.size());
  for (const std::uint64_t part : parts) {
    halves.push_back(static_cast<std::int64_t>(part & 0xFFFFFFFFU));
    halves.push_back(static_cast<std::int64_t>(part >> 32U));
  }
  comm.sum(halves.data(), static_cast<int>(halves.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = static_cast<std::uint64_t>(halves[2 * i]) + (static_cast<std::uint64_t>(halves[2 * i + 1]) << 32U);
  }
}

std::uint64_t text_checksum(std::string_view text) { return XXH3_64bits(text.data(), text.size()); }

std::string text_digest(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return hex(hash.high64) + hex(hash.low64);
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

bool parse_hex(std::string_view text, std::uint64_t& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() && text == hex(value);
}

}  // namespace rouleau
