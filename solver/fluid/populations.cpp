// SPDX-License-Identifier: BSD-3-Clause
// Periodic halos of the populations within one block.
#include "fluid/populations.hpp"

#include "base/halo.hpp"

namespace rouleau {

template <class Real>
void fill_periodic(Populations<Real>& f, int axis) {
  const int n = f.layout.size[axis];
  for (const int q : directions_out(axis, 0)) copy_layer(f.layout, f.rows(q), axis, 0, n);
  for (const int q : directions_out(axis, 1)) copy_layer(f.layout, f.rows(q), axis, n - 1, -1);
}

template void fill_periodic(Populations<float>&, int);
template void fill_periodic(Populations<double>&, int);

}  // namespace rouleau
