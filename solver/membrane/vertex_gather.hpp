// SPDX-License-Identifier: BSD-3-Clause
// Sums of triangle values over the triangles around each vertex, eight vertices at a time.
#pragma once

#include <array>

#include "membrane/cells.hpp"

namespace rouleau {

/// Where the values of a vertex's triangles stand, in ascending triangle order. Vertices are taken in blocks of eight;
/// a block has as many rows as its busiest vertex has triangles, the others' rows end in the zero slot.
class VertexGather {
 public:
  static constexpr int width = 8;

  /// The value of corner k of triangle t stands at k * corner_stride + t; `zero_slot` holds 0 for ever.
  VertexGather(const VertexTriangles& around, std::int32_t corner_stride, std::int32_t zero_slot);

  [[nodiscard]] int blocks() const { return static_cast<int>(begin_.size()) - 1; }

  /// Sums for the eight vertices from `block * width` on. `values`: K arrays; lanes past the last vertex hold 0.
  template <std::size_t K>
  [[nodiscard]] std::array<std::array<double, width>, K> sum(int block,
                                                             const std::array<const double*, K>& values) const {
    std::array<std::array<double, width>, K> sums{};
    for (std::int32_t row = begin_[block]; row < begin_[block + 1]; ++row) {
      const std::int32_t* slots = slots_.data() + std::ptrdiff_t{row} * width;
      for (std::size_t k = 0; k < K; ++k) {
#pragma omp simd
        for (int l = 0; l < width; ++l) sums[k][l] += values[k][slots[l]];
      }
    }
    return sums;
  }

 private:
  Array<std::int32_t> begin_;  ///< [blocks + 1] rows
  Array<std::int32_t> slots_;  ///< [rows][width]
};

}  // namespace rouleau
