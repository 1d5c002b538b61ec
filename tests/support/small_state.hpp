// SPDX-License-Identifier: BSD-3-Clause
// A small persistent state with every kind of item, filled by global index so that any decomposition can be compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "base/grid.hpp"
#include "parallel/communicator.hpp"
#include "storage/checkpoint.hpp"
#include "storage/metadata.hpp"
#include "storage/persistent.hpp"

namespace rouleau::testing {

/// A well mixed number of a few arguments; not the mixing of the code under test.
inline std::uint64_t scramble(std::uint64_t a, std::uint64_t b, std::uint64_t c = 0) {
  std::uint64_t h = 0xCBF29CE484222325U;
  for (const std::uint64_t v : {a, b, c}) {
    h = (h ^ v) * 0x100000001B3U;
    h ^= h >> 29U;
    h *= 0xFF51AFD7ED558CCDU;
    h ^= h >> 32U;
  }
  return h;
}

/// Finite values of all kinds: ordinary ones, both zeros, the smallest and the largest.
template <class T>
T sample_value(std::uint64_t h) {
  if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(h);
  } else {
    switch (h % 64) {
      case 0:
        return T{0};
      case 1:
        return -T{0};
      case 2:
        return std::numeric_limits<T>::denorm_min();
      case 3:
        return -std::numeric_limits<T>::max();
      default:
        return static_cast<T>(static_cast<double>(static_cast<std::int64_t>(h)) * 0x1p-63);
    }
  }
}

/// Cuts a lattice for `parts` ranks in one of three ways: along x, along z, or in both.
inline Block block_of(const Int3& n, int way, int part, int parts) {
  const auto cut = [](int size, int p, int of) {
    // Uneven on purpose.
    const int begin = p == 0 ? 0 : std::min(size, size * p / of + 1);
    const int end = p == of - 1 ? size : std::min(size, size * (p + 1) / of + 1);
    return std::pair{begin, end - begin};
  };
  Block block{{0, 0, 0}, n};
  if (way == 2 && parts % 2 == 0) {
    std::tie(block.begin[0], block.size[0]) = cut(n[0], part % 2, 2);
    std::tie(block.begin[2], block.size[2]) = cut(n[2], part / 2, parts / 2);
  } else {
    const auto axis = static_cast<std::size_t>(way == 1 ? 2 : way == 2 ? 1 : 0);
    std::tie(block.begin[axis], block.size[axis]) = cut(n[axis], part, parts);
  }
  return block;
}

/// Owns what its list points to.
template <class Real>
struct SmallState {
  Lattice lattice;
  Block block;
  std::vector<Field<Real>> f;
  Field<std::uint8_t> flags;
  std::vector<double> X, X_reference, controller;
  std::vector<std::int32_t> triangles, ranges;
  std::vector<std::int64_t> counters;

  SmallState(const Int3& n, const Block& own) : lattice{n, {true, true, true}}, block(own) {
    for (int c = 0; c < 5; ++c) f.emplace_back(own.size, 1);
    flags = Field<std::uint8_t>(own.size, 2);
    X.resize(3 * 9);
    X_reference.resize(3 * 9);
    triangles = {0, 1, 5, 6, 7, 8, 1, 2, 6, 7, 8, 5, 2, 3, 7, 8, 5, 6};
    ranges = {0, 4, 0, 2, 5, 9, 2, 6};
    controller.resize(2);
    counters.resize(1);
  }

  /// The state at a step: a pure function of the step and the global index. Halos keep rubbish.
  void fill(std::uint64_t step) {
    for (std::size_t c = 0; c < f.size(); ++c)
      each_node(f[c], [&](std::uint64_t i) { return sample_value<Real>(scramble(step, c, i)); });
    each_node(flags, [&](std::uint64_t i) { return static_cast<std::uint8_t>(scramble(step, 77, i) & 1U); });
    for (std::size_t i = 0; i < X.size(); ++i) {
      X[i] = sample_value<double>(scramble(step, 88, i) | 4U);
      X_reference[i] = sample_value<double>(scramble(0, 99, i) | 4U);
    }
    for (std::size_t i = 0; i < controller.size(); ++i) controller[i] = sample_value<double>(scramble(step, 111, i));
    counters[0] = static_cast<std::int64_t>(scramble(step, 122));
  }

  template <class T, class Value>
  void each_node(Field<T>& field, const Value& value) {
    std::memset(field.data.data(), 0x5A, field.data.size() * sizeof(T));
    for (int k = 0; k < block.size[2]; ++k) {
      for (int j = 0; j < block.size[1]; ++j) {
        for (int i = 0; i < block.size[0]; ++i) {
          const Int3& n = lattice.size;
          const auto index = ((block.begin[2] + k) * n[1] + block.begin[1] + j) * n[0] + block.begin[0] + i;
          field(i, j, k) = static_cast<T>(value(static_cast<std::uint64_t>(index)));
        }
      }
    }
  }

  [[nodiscard]] PersistentState list() {
    PersistentState state{lattice, block, {}, {}};
    LatticeItem populations{"fluid/f", sizeof(Real) == 4 ? ElementType::f32 : ElementType::f64, f[0].layout, {}};
    for (Field<Real>& component : f) populations.data.push_back(component.data.data());
    state.lattice_items = {populations, {"interior/flags", ElementType::u8, flags.layout, {flags.data.data()}}};
    state.replicated_items = {{"cells/X", ElementType::f64, {3, 9}, X.data()},
                              {"cells/X_reference", ElementType::f64, {3, 9}, X_reference.data()},
                              {"cells/triangles", ElementType::i32, {3, 6}, triangles.data()},
                              {"cells/ranges", ElementType::i32, {2, 4}, ranges.data()},
                              {"controller", ElementType::f64, {2}, controller.data()},
                              {"sampler/counters", ElementType::i64, {1}, counters.data()},
                              {"sampler/nothing", ElementType::f64, {0}, nullptr}};
    return state;
  }

  /// Owned nodes and replicated values, bit for bit.
  [[nodiscard]] bool same_bits(const SmallState& other) const {
    const auto same = [&](const auto& a, const auto& b) {
      for (int k = 0; k < block.size[2]; ++k) {
        for (int j = 0; j < block.size[1]; ++j) {
          const std::size_t row = static_cast<std::size_t>(block.size[0]) * sizeof(a.data[0]);
          if (row > 0 && std::memcmp(&a(0, j, k), &b(0, j, k), row) != 0) return false;
        }
      }
      return true;
    };
    const auto same_vector = [](const auto& a, const auto& b) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    bool all = same(flags, other.flags);
    for (std::size_t c = 0; c < f.size(); ++c) all = all && same(f[c], other.f[c]);
    return all && same_vector(X, other.X) && same_vector(X_reference, other.X_reference) &&
           same_vector(triangles, other.triangles) && same_vector(ranges, other.ranges) &&
           same_vector(controller, other.controller) && counters == other.counters;
  }
};

inline CheckpointMetadata small_metadata(std::int64_t step, int attempt = 1) {
  CheckpointMetadata metadata;
  metadata.step = step;
  metadata.time_s = static_cast<double>(step) / 3.0 * 1e-6;
  metadata.attempt = attempt;
  metadata.parameters = {{"fluid.lambda", {"4.75", "5", true}},
                         {"numerics.node_spacing_um", {"0.5", "", true}},
                         {"time.end_time_s", {"0.2", "", false}}};
  metadata.identity = "0123456789abcdef0123456789abcdef";
  metadata.version = "0.1.0";
  metadata.git = "abc123";
  metadata.samples = {17, "00000000000000ff"};
  metadata.mesh_digest = "ff";
  metadata.node_spacing_um = 0.5;
  return metadata;
}

}  // namespace rouleau::testing
