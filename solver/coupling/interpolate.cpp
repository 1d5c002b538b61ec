// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/interpolate.hpp"

#include <algorithm>

#include "base/lanes.hpp"

namespace rouleau {
namespace {

/// A stencil along one axis that something cuts: local nodes from `first` on, within the block or its halo.
template <int width>
AxisStencil<width> reading_stencil(const Stencils& s, int axis, std::size_t v) {
  const int n = s.lattice.size[axis], begin = s.block.begin[axis], size = s.block.size[axis];
  const int first = s.first[axis][v];
  const double* const weight = s.weights(axis, v);
  if (!s.lattice.periodic[axis] && (first < 0 || first + width > n)) {
    AxisStencil<width> inside = dropped<width>(first, weight, n);
    inside.first -= begin;
    return inside;
  }
  AxisStencil<width> all{first - begin, {}, {}};
  std::copy_n(weight, width, all.weight.begin());
  // The nearest node is owned, so the stencil reaches at most two nodes out: of its images, take the one that does.
  if (s.lattice.periodic[axis]) {
    if (all.first + width > size + 2) all.first -= n;
    if (all.first < -2) all.first += n;
  }
  return all;
}

/// What the walls add: their velocity times the weight that fell beyond them, the later axis first in line.
template <int width>
Vec3 wall_part(const AxisStencil<width>& x, const AxisStencil<width>& y, const AxisStencil<width>& z,
               const WallVelocities& walls) {
  const auto of_axis = [&](const AxisStencil<width>& s, int axis) -> Vec3 {
    return s.beyond[0] * walls.u[axis][0] + s.beyond[1] * walls.u[axis][1];
  };
  const double within_z = 1.0 - (z.beyond[0] + z.beyond[1]);
  const double within_y = 1.0 - (y.beyond[0] + y.beyond[1]);
  return of_axis(z, 2) + within_z * (of_axis(y, 1) + within_y * of_axis(x, 0));
}

/// Sum over the nodes of a stencil whose first node stands at `first`. One sum a node along x, added up at the end.
template <int width, class Real>
Vec3 weighted_sum(const std::array<const Real*, 3>& u, const Layout& layout, std::ptrdiff_t first, const double* x,
                  const double* y, const double* z) {
  std::array<Lanes<double, width>, 3> sum{};
  for (int c = 0; c < width; ++c)
    for (int b = 0; b < width; ++b) {
      const double share = y[b] * z[c];
      const std::ptrdiff_t row = first + b * layout.stride_y + c * layout.stride_z;
      for (std::size_t component = 0; component < 3; ++component)
        sum[component] += share * load_lanes<double, width>(u[component] + row);
    }
  Vec3 total = Vec3::Zero();
  for (std::size_t component = 0; component < 3; ++component) {
    const auto weighted = load_lanes<double, width>(x) * sum[component];
    for (int a = 0; a < width; ++a) total[static_cast<Eigen::Index>(component)] += weighted[a];
  }
  return total;
}

template <class Real, int width>
Vec3 velocity_at_cut(const std::array<const Real*, 3>& u, const Layout& layout, const WallVelocities& walls,
                     const Stencils& s, std::size_t v) {
  const auto x = reading_stencil<width>(s, 0, v);
  const auto y = reading_stencil<width>(s, 1, v);
  const auto z = reading_stencil<width>(s, 2, v);
  return weighted_sum<width>(u, layout, layout.index(x.first, y.first, z.first), x.weight.data(), y.weight.data(),
                             z.weight.data()) +
         wall_part(x, y, z, walls);
}

template <class Phi, class Real>
void interpolate_with(const VectorField<Real>& field, const WallVelocities& walls, const Stencils& s, VectorArray& U) {
  constexpr int width = Phi::width;
  const Layout layout = field[0].layout;
  const std::array<const Real*, 3> u{field[0].data.data(), field[1].data.data(), field[2].data.data()};
  for (const std::int32_t vertex : s.owned) {
    const auto v = static_cast<std::size_t>(vertex);
    const Int3 local = s.local_first(v);
    set(U, v,
        s.is_whole(local) ? weighted_sum<width>(u, layout, layout.index(local[0], local[1], local[2]), s.weights(0, v),
                                                s.weights(1, v), s.weights(2, v))
                          : velocity_at_cut<Real, width>(u, layout, walls, s, v));
  }
}

}  // namespace

template <class Real>
void interpolate(const VectorField<Real>& u, const WallVelocities& walls, const Stencils& stencils, VectorArray& U) {
  with_kernel(stencils.kernel, [&](auto phi) { interpolate_with<decltype(phi)>(u, walls, stencils, U); });
}

template void interpolate(const VectorField<float>&, const WallVelocities&, const Stencils&, VectorArray&);
template void interpolate(const VectorField<double>&, const WallVelocities&, const Stencils&, VectorArray&);

}  // namespace rouleau
