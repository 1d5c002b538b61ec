// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/interpolate.hpp"

#include <algorithm>
#include <cmath>

namespace rouleau {
namespace {

/// A vertex's stencil along one axis: local nodes from `stencil.first` on, within the block or its halo.
template <int width>
AxisStencil<width> reading_stencil(const Stencils& s, int axis, std::int32_t v) {
  const int n = s.lattice.size[axis], begin = s.block.begin[axis], size = s.block.size[axis];
  const int first = s.first[axis][static_cast<std::size_t>(v)];
  const double* const weight = s.weight[axis].data() + std::ptrdiff_t{width} * v;
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

template <class Phi, class Real>
void interpolate_with(const VectorField<Real>& u, const WallVelocities& walls, const Stencils& s, VectorArray& U) {
  constexpr int width = Phi::width;
  const Layout& layout = u[0].layout;
  for (const std::int32_t v : s.owned) {
    const auto x = reading_stencil<width>(s, 0, v);
    const auto y = reading_stencil<width>(s, 1, v);
    const auto z = reading_stencil<width>(s, 2, v);
    // One sum a node of the x stencil: the four lanes of a vector.
    std::array<std::array<double, width>, 3> sum{};
    for (int c = 0; c < width; ++c)
      for (int b = 0; b < width; ++b) {
        const double share = y.weight[static_cast<std::size_t>(b)] * z.weight[static_cast<std::size_t>(c)];
        const std::ptrdiff_t start = layout.index(x.first, y.first + b, z.first + c);
        for (std::size_t component = 0; component < 3; ++component) {
          const Real* const row = u[component].data.data() + start;
          double* const lane = sum[component].data();
#pragma omp simd
          for (int a = 0; a < width; ++a) lane[a] += share * static_cast<double>(row[a]);
        }
      }
    Vec3 velocity = wall_part(x, y, z, walls);
    for (std::size_t component = 0; component < 3; ++component)
      for (std::size_t a = 0; a < width; ++a)
        velocity[static_cast<Eigen::Index>(component)] += x.weight[a] * sum[component][a];
    set(U, static_cast<std::size_t>(v), velocity);
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
