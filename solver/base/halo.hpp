// SPDX-License-Identifier: BSD-3-Clause
// Which layers of a field its halo is filled from, and copying one when an axis is periodic within one block.
//
// Halos are filled axis after axis, x, y, z. Each phase carries along the halo nodes of the axes before it, so that
// edges and corners arrive without messages of their own.
#pragma once

#include <algorithm>

#include "base/grid.hpp"

namespace rouleau {

/// Local nodes [begin, end) along each axis.
struct Box {
  Int3 begin{}, end{};
};

/// Layers [first, last) along `axis`; along the others what the phase of `axis` carries: owned and halo nodes of the
/// axes before it, owned nodes of those after it.
inline Box phase_box(const Layout& layout, int axis, int first, int last) {
  Box box;
  for (int a = 0; a < 3; ++a) {
    const int halo = a < axis ? layout.halo : 0;
    box.begin[a] = -halo;
    box.end[a] = layout.size[a] + halo;
  }
  box.begin[axis] = first;
  box.end[axis] = last;
  return box;
}

/// Sets layer `to` along `axis` from layer `from` of the same field.
template <class T>
void copy_layer(const Layout& layout, const Rows<T>& rows, int axis, int from, int to) {
  const Box box = phase_box(layout, axis, to, to + 1);
  const Int3 shift{axis == 0 ? from - to : 0, axis == 1 ? from - to : 0, axis == 2 ? from - to : 0};
  for (int k = box.begin[2]; k < box.end[2]; ++k)
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      const T* const source = rows(j + shift[1], k + shift[2]) + shift[0];
      std::copy(source + box.begin[0], source + box.end[0], rows(j, k) + box.begin[0]);
    }
}

}  // namespace rouleau
