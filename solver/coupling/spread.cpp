// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/spread.hpp"

#include <algorithm>
#include <bit>

#include "base/lanes.hpp"
#include "coupling/walls.hpp"

namespace rouleau {
namespace {

/// What one vertex adds: force times weight along x, and the weights along y and z that share it out among the rows.
template <class Real, int width>
struct Contribution {
  std::array<Lanes<Real, width>, 3> along_x;  ///< [component]
  std::array<Real, width> y, z;
};

/// Which nodes of a stencil along one axis the block owns.
template <int width>
struct OwnedStencil {
  std::array<int, width> node;  ///< local; < 0 where another block owns the node
  std::array<double, width> weight;
};

template <int width>
OwnedStencil<width> owned_stencil(const Stencils& s, int axis, std::size_t v) {
  const int n = s.lattice.size[axis];
  const double* const weight = s.weights(axis, v);
  int first = s.first[axis][v];
  OwnedStencil<width> own;
  std::copy_n(weight, width, own.weight.begin());
  if (!s.lattice.periodic[axis] && (first < 0 || first + width > n)) {
    const AxisStencil<width> folded = reflected<width>(first, weight, n);
    first = folded.first;
    own.weight = folded.weight;
  }
  for (int a = 0; a < width; ++a) own.node[static_cast<std::size_t>(a)] = s.owned_or_none(axis, first + a);
  return own;
}

template <class Real, int width>
Contribution<Real, width> contribution(const Vec3& force, const double* x, const double* y, const double* z) {
  Contribution<Real, width> all;
  const auto weight = load_lanes<double, width>(x);
  for (std::size_t component = 0; component < 3; ++component)
    all.along_x[component] = load_lanes<Real, width>(force[static_cast<Eigen::Index>(component)] * weight);
  std::copy_n(y, width, all.y.begin());
  std::copy_n(z, width, all.z.begin());
  return all;
}

/// Adds to a stencil whose first node stands at `first`.
template <class Real, int width>
void add_whole(const Contribution<Real, width>& all, const Layout& layout, std::ptrdiff_t first,
               const std::array<Real*, 3>& g) {
  for (std::size_t c = 0; c < width; ++c)
    for (std::size_t b = 0; b < width; ++b) {
      const Real share = all.y[b] * all.z[c];
      const std::ptrdiff_t row =
          first + static_cast<std::ptrdiff_t>(b) * layout.stride_y + static_cast<std::ptrdiff_t>(c) * layout.stride_z;
      std::array<Lanes<Real, width>, 3> sum;
      for (std::size_t component = 0; component < 3; ++component)
        sum[component] = load_lanes<Real, width>(g[component] + row) + share * all.along_x[component];
      for (std::size_t component = 0; component < 3; ++component)
        store_lanes<width>(sum[component], g[component] + row);
    }
}

/// The same sums, for the nodes that this block owns of a stencil that something cuts.
template <class Real, int width>
void add_owned(const Stencils& s, std::size_t v, const Vec3& force, const Layout& layout,
               const std::array<Real*, 3>& g) {
  const auto x = owned_stencil<width>(s, 0, v);
  const auto y = owned_stencil<width>(s, 1, v);
  const auto z = owned_stencil<width>(s, 2, v);
  const auto all = contribution<Real, width>(force, x.weight.data(), y.weight.data(), z.weight.data());
  for (std::size_t c = 0; c < width; ++c)
    for (std::size_t b = 0; b < width; ++b) {
      if (y.node[b] < 0 || z.node[c] < 0) continue;
      const Real share = all.y[b] * all.z[c];
      const std::ptrdiff_t row = layout.index(0, y.node[b], z.node[c]);
      for (std::size_t a = 0; a < width; ++a) {
        if (x.node[a] < 0) continue;
        for (std::size_t component = 0; component < 3; ++component)
          g[component][row + x.node[a]] += share * all.along_x[component][a];
      }
    }
}

template <class Phi, class Real>
void spread_with(const VectorArray& F, const Stencils& s, VectorField<Real>& field) {
  constexpr int width = Phi::width;
  const Layout layout = field[0].layout;
  const std::array<Real*, 3> g{field[0].data.data(), field[1].data.data(), field[2].data.data()};
  for (const std::int32_t vertex : s.spreading) {
    const auto v = static_cast<std::size_t>(vertex);
    const Vec3 force = at(F, v);
    const Int3 local = s.local_first(v);
    if (s.is_whole(local))
      add_whole(contribution<Real, width>(force, s.weights(0, v), s.weights(1, v), s.weights(2, v)), layout,
                layout.index(local[0], local[1], local[2]), g);
    else
      add_owned<Real, width>(s, v, force, layout, g);
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
  const int size = stencils.block.size[0];
  for (int k = 0; k < stencils.block.size[2]; ++k)
    for (int j = 0; j < stencils.block.size[1]; ++j) {
      std::uint8_t& written = stencils.written_rows[stencils.row(j, k)];
      for (unsigned left = written; left != 0; left &= left - 1) {
        const int begin = std::countr_zero(left) << stencils.segment_shift;
        const int end = std::min(begin + (1 << stencils.segment_shift), size);
        for (Field<Real>& component : g) std::fill_n(&component(begin, j, k), end - begin, Real{0});
      }
      written = 0;
    }
}

template void spread(const VectorArray&, Stencils&, VectorField<float>&);
template void spread(const VectorArray&, Stencils&, VectorField<double>&);
template void clear_touched(Stencils&, VectorField<float>&);
template void clear_touched(Stencils&, VectorField<double>&);

}  // namespace rouleau
