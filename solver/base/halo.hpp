// SPDX-License-Identifier: BSD-3-Clause
// Which layers of a field its halo is filled from, and the filling when an axis is periodic within one block.
//
// Halos are filled axis after axis, x, y, z. Each phase carries along the halo nodes of the axes before it, so that
// edges and corners arrive without messages of their own.
#pragma once

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

/// Sets layer `to` along `axis` from layer `from` of the same values: data[index] with `layout`.
template <class T>
void copy_layer(const Layout& layout, T* data, int axis, int from, int to) {
  const Box box = phase_box(layout, axis, to, to + 1);
  const Int3 unit{axis == 0, axis == 1, axis == 2};
  const std::ptrdiff_t shift = layout.index(unit[0], unit[1], unit[2]) - layout.index(0, 0, 0);
  for (int k = box.begin[2]; k < box.end[2]; ++k)
    for (int j = box.begin[1]; j < box.end[1]; ++j)
      for (std::ptrdiff_t n = layout.index(box.begin[0], j, k), end = layout.index(box.end[0], j, k); n < end; ++n)
        data[n] = data[n + (from - to) * shift];
}

/// Fills both halos along an axis whose period lies within the block. Call for x, y, z in this order.
template <class T>
void fill_periodic(Field<T>& field, int axis) {
  const int n = field.layout.size[axis];
  for (int d = 1; d <= field.layout.halo; ++d) {
    copy_layer(field.layout, field.data.data(), axis, n - 1 - (d - 1) % n, -d);
    copy_layer(field.layout, field.data.data(), axis, (d - 1) % n, n - 1 + d);
  }
}

}  // namespace rouleau
