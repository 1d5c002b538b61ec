// SPDX-License-Identifier: BSD-3-Clause
// The 19 populations of a block, direction after direction, in one copy that streams by renumbering its rows.
#pragma once

#include <algorithm>

#include "base/grid.hpp"
#include "fluid/lattice.hpp"

namespace rouleau {

/// f_q - w_q at the nodes of a block, halo 1. Stored minus the weights because the flow is a deviation of about 1e-3
/// from them: single precision then resolves 1e-10 of the weight instead of 1e-7.
///
/// A step leaves f_q of the row (j, k) where it found it, in the row (j, k) - c_q, and `advance` renumbers the rows,
/// each direction by its own offset, instead of moving them. Each row in memory is read and written for one row of
/// nodes only, so that the order of the rows does not matter and one copy is enough.
template <class Real>
struct Populations {
  Layout layout;                         ///< of each direction while it is straight
  std::ptrdiff_t stride_q = 0;           ///< elements from direction to direction
  std::array<std::ptrdiff_t, Q> turn{};  ///< where the rows of each direction begin, see Rows
  Array<Real> data;

  explicit Populations(const Int3& owned) : layout(owned, 1) {
    // A step walks 19 streams side by side. Spacing them 27 cache lines apart modulo a page spreads them over all sets
    // of a first-level cache (19 multiples of 27 leave gaps of 3 or 4 lines in 64).
    constexpr std::ptrdiff_t line = cache_line / sizeof(Real), page = 64 * line;
    stride_q = (layout.count - 27 * line + page - 1) / page * page + 27 * line;
    data.resize(static_cast<std::size_t>(stride_q * Q));
  }

  /// The rows of direction q.
  [[nodiscard]] Rows<Real> rows(int q) { return rows_of(data.data(), q); }
  [[nodiscard]] Rows<const Real> rows(int q) const { return rows_of(data.data(), q); }
  /// f_q of one node.
  [[nodiscard]] Real& at(int q, int i, int j, int k) { return rows(q)(j, k)[i]; }
  [[nodiscard]] const Real& at(int q, int i, int j, int k) const { return rows(q)(j, k)[i]; }

  /// Streams along y and z: what was the row (j, k) - c_q of direction q is now its row (j, k).
  void advance() {
    for (int q = 0; q < Q; ++q) {
      const Rows<Real> r = rows(q);
      const std::ptrdiff_t offset = c_q[q][1] + std::ptrdiff_t{c_q[q][2]} * r.size_y;
      turn[q] = (r.turn - offset + r.count) % r.count;
    }
  }

  /// Moves every row to its place in `layout`; no value changes.
  void straighten() {
    for (int q = 0; q < Q; ++q) {
      const Rows<Real> r = rows(q);
      Real* const begin = r.first - layout.halo;
      std::rotate(begin, begin + r.turn * r.stride, begin + r.count * r.stride);
      turn[q] = 0;
    }
  }

  /// While straight: direction q, whose value of node (i, j, k) stands at [layout.index(i, j, k)].
  [[nodiscard]] Real* direction(int q) { return data.data() + q * stride_q; }

 private:
  template <class T>
  [[nodiscard]] Rows<T> rows_of(T* values, int q) const {
    Rows<T> r = layout.rows(values + q * stride_q);
    r.turn = turn[q];
    return r;
  }
};

/// Fills the halos along an axis whose period lies within the block, with the five directions that cross each face.
/// Call for x, y, z in this order after a step, then `fill_walls`.
template <class Real>
void fill_periodic(Populations<Real>& f, int axis);

extern template void fill_periodic(Populations<float>&, int);
extern template void fill_periodic(Populations<double>&, int);

}  // namespace rouleau
