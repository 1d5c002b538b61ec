// SPDX-License-Identifier: BSD-3-Clause
// What memory allows: the populations' traffic without their arithmetic.
#pragma once

#include "base/grid.hpp"
#include "base/pack.hpp"
#include "fluid/lattice.hpp"

namespace rouleau::speed {

/// 19 arrays of a fluid's size, scaled in place in the order of the fluid's step: row by row, and in a row pack by pack
/// of all directions. A step that streams in place reads and writes each value once.
template <class Real>
class ScaledInPlace {
 public:
  static constexpr std::ptrdiff_t bytes_per_node = 2 * Q * sizeof(Real);

  explicit ScaledInPlace(const Int3& size) : layout_(size, 1) {
    // 27 cache lines apart modulo a page: 19 streams then fall into different sets of a first-level cache.
    constexpr std::ptrdiff_t line = cache_line / sizeof(Real), page = 64 * line;
    stride_q_ = (layout_.count - 27 * line + page - 1) / page * page + 27 * line;
    data_.assign(static_cast<std::size_t>(stride_q_ * Q), Real(1e-3));
  }

  void scale() {
    for (int k = 0; k < layout_.size[2]; ++k)
      for (int j = 0; j < layout_.size[1]; ++j) {
        Real* const row = data_.data() + layout_.index(0, j, k);
        for (int x = 0; x < layout_.size[0]; x += lanes<Real>)
          unrolled<Q>([&](auto q) ROW_INLINE {
            Real* const f = row + q * stride_q_ + x;
            store<Real>(f, load(f) * Real(1.0000001));
          });
      }
    asm volatile("" ::"r"(data_.data()) : "memory");
  }

 private:
  Layout layout_;
  std::ptrdiff_t stride_q_ = 0;
  Array<Real> data_;
};

}  // namespace rouleau::speed
