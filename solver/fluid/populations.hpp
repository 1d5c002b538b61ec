// SPDX-License-Identifier: BSD-3-Clause
// One copy of the 19 populations of a block, direction after direction.
#pragma once

#include "base/grid.hpp"
#include "fluid/lattice.hpp"

namespace rouleau {

/// f_q - w_q at the nodes of a block, halo 1. Stored minus the weights because the flow is a deviation of about 1e-3
/// from them: single precision then resolves 1e-10 of the weight instead of 1e-7.
template <class Real>
struct Populations {
  Layout layout;
  std::ptrdiff_t stride_q = 0;  ///< elements from direction to direction
  Array<Real> data;

  Populations() = default;
  explicit Populations(const Int3& owned) : layout(owned, 1) {
    // A step walks 38 streams side by side. Spacing them 27 cache lines apart modulo a page spreads them over all sets
    // of a first-level cache (19 multiples of 27 leave gaps of 3 or 4 lines in 64).
    constexpr std::ptrdiff_t line = cache_line / sizeof(Real), page = 64 * line;
    stride_q = (layout.count + page - 1) / page * page + 27 * line;
    data.resize(static_cast<std::size_t>(stride_q * Q));
  }

  /// Direction q: value of node (i, j, k) at [layout.index(i, j, k)].
  [[nodiscard]] Real* direction(int q) { return data.data() + q * stride_q; }
  [[nodiscard]] const Real* direction(int q) const { return data.data() + q * stride_q; }
  /// Where node n + c_q stands relative to node n.
  [[nodiscard]] std::ptrdiff_t offset(int q) const {
    return c_q[q][0] + c_q[q][1] * layout.stride_y + c_q[q][2] * layout.stride_z;
  }
};

/// Fills the halos along an axis whose period lies within the block, with the five directions that cross each face.
/// Call for x, y, z in this order after a step, then `fill_walls`.
template <class Real>
void fill_periodic(Populations<Real>& f, int axis);

extern template void fill_periodic(Populations<float>&, int);
extern template void fill_periodic(Populations<double>&, int);

}  // namespace rouleau
