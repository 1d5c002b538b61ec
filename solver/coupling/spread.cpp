// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/spread.hpp"

#include <algorithm>

#include "coupling/walls.hpp"

namespace rouleau {
namespace {

/// The owned part of a vertex's stencil along one axis.
template <int width>
struct OwnedStencil {
  std::array<int, width> node;  ///< local; < 0 where another block owns the node
  std::array<double, width> weight;
  bool is_whole;  ///< all nodes are owned, and stand one after the other
};

template <int width>
OwnedStencil<width> owned_stencil(const Stencils& s, int axis, std::int32_t v) {
  const int n = s.lattice.size[axis], size = s.block.size[axis];
  const double* const weight = s.weight[axis].data() + std::ptrdiff_t{width} * v;
  int first = s.first[axis][static_cast<std::size_t>(v)];
  OwnedStencil<width> own;
  std::copy_n(weight, width, own.weight.begin());
  if (!s.lattice.periodic[axis] && (first < 0 || first + width > n)) {
    const AxisStencil<width> folded = reflected<width>(first, weight, n);
    first = folded.first;
    own.weight = folded.weight;
  }
  const int start = first - s.block.begin[axis];
  own.is_whole = start >= 0 && start + width <= size;
  for (int a = 0; a < width; ++a) {
    int local = start + a;
    if (s.lattice.periodic[axis]) local = first + a >= n ? local - n : local;
    own.node[static_cast<std::size_t>(a)] = local >= 0 && local < size ? local : -1;
  }
  return own;
}

template <int width, class Real>
void add_to_row(const OwnedStencil<width>& x, const std::array<Real, width>& weight, Real force, Real* row) {
  if (x.is_whole) {
    Real* const out = row + x.node[0];
#pragma omp simd
    for (int a = 0; a < width; ++a) out[a] += force * weight[static_cast<std::size_t>(a)];
    return;
  }
  for (std::size_t a = 0; a < width; ++a)
    if (x.node[a] >= 0) row[x.node[a]] += force * weight[a];
}

template <class Phi, class Real>
void spread_with(const VectorArray& F, const Stencils& s, VectorField<Real>& g) {
  constexpr int width = Phi::width;
  const Layout& layout = g[0].layout;
  for (const std::int32_t v : s.spreading) {
    const auto x = owned_stencil<width>(s, 0, v);
    const auto y = owned_stencil<width>(s, 1, v);
    const auto z = owned_stencil<width>(s, 2, v);
    std::array<Real, width> weight;
    for (std::size_t a = 0; a < width; ++a) weight[a] = static_cast<Real>(x.weight[a]);
    const Vec3 force = at(F, static_cast<std::size_t>(v));
    for (std::size_t c = 0; c < width; ++c) {
      if (z.node[c] < 0) continue;
      for (std::size_t b = 0; b < width; ++b) {
        if (y.node[b] < 0) continue;
        const double share = y.weight[b] * z.weight[c];
        const std::ptrdiff_t row = layout.index(0, y.node[b], z.node[c]);
        for (int component = 0; component < 3; ++component)
          add_to_row<width, Real>(x, weight, static_cast<Real>(share * force[component]),
                                  g[component].data.data() + row);
      }
    }
  }
}

}  // namespace

template <class Real>
void spread(const VectorArray& F, Stencils& stencils, VectorField<Real>& g) {
  with_kernel(stencils.kernel, [&](auto phi) { spread_with<decltype(phi)>(F, stencils, g); });
  for (std::size_t row = 0; row < stencils.rows.size(); ++row) stencils.written_rows[row] |= stencils.rows[row];
}

template <class Real>
void clear_touched(Stencils& stencils, VectorField<Real>& g) {
  for (int k = 0; k < stencils.block.size[2]; ++k)
    for (int j = 0; j < stencils.block.size[1]; ++j) {
      std::uint8_t& is_written = stencils.written_rows[stencils.row(j, k)];
      if (!is_written) continue;
      for (Field<Real>& component : g) std::fill_n(&component(0, j, k), stencils.block.size[0], Real{0});
      is_written = 0;
    }
}

template void spread(const VectorArray&, Stencils&, VectorField<float>&);
template void spread(const VectorArray&, Stencils&, VectorField<double>&);
template void clear_touched(Stencils&, VectorField<float>&);
template void clear_touched(Stencils&, VectorField<double>&);

}  // namespace rouleau
