// SPDX-License-Identifier: BSD-3-Clause
// Half-way bounce-back walls.
#include "fluid/walls.hpp"

#include "base/error.hpp"

namespace rouleau {

namespace {

bool touches_wall(const Lattice& lattice, const Block& block, int axis, int side) {
  if (lattice.periodic[axis]) return false;
  return side == 0 ? block.begin[axis] == 0 : block.begin[axis] + block.size[axis] == lattice.size[axis];
}

/// One wall: for the owned nodes n next to it and each direction q that comes from beyond it.
template <class Real>
void fill_wall(Fluid<Real>& fluid, int axis, int side) {
  Int3 begin{0, 0, 0}, end = fluid.block.size;
  begin[axis] = side == 0 ? 0 : end[axis] - 1;
  end[axis] = begin[axis] + 1;
  const Vec3& u = fluid.wall_velocity[axis][side];
  for (const int back : directions_out(axis, side)) {
    const int q = opposite(back);
    const Real moving = Real(6 * w_q(q) * (c_q[q][0] * u[0] + c_q[q][1] * u[1] + c_q[q][2] * u[2]));
    const Real* leaving = fluid.f.direction(back);
    Real* arriving = fluid.f.direction(q) - fluid.f.offset(q);
    for (int k = begin[2]; k < end[2]; ++k)
      for (int j = begin[1]; j < end[1]; ++j) {
        const std::ptrdiff_t first = fluid.f.layout.index(begin[0], j, k), last = first + end[0] - begin[0];
        for (std::ptrdiff_t n = first; n < last; ++n) arriving[n] = leaving[n] + moving;
      }
  }
}

}  // namespace

template <class Real>
void fill_walls(Fluid<Real>& fluid) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (touches_wall(fluid.lattice, fluid.block, axis, side)) fill_wall(fluid, axis, side);
}

template <class Real>
void fill_halos(Fluid<Real>& fluid) {
  for (int axis = 0; axis < 3; ++axis)
    if (fluid.lattice.periodic[axis]) fill_periodic(fluid.f, axis);
  fill_walls(fluid);
}

void require_wall_velocities(const Lattice& lattice, const std::array<std::array<Vec3, 2>, 3>& wall_velocity) {
  constexpr double fastest = 0.17;  // Mach 0.3: the equilibrium is of second order in u
  constexpr std::array<char, 3> name{'x', 'y', 'z'};
  for (int axis = 0; axis < 3; ++axis)
    for (const Vec3& u : wall_velocity[axis]) {
      if (!(u.norm() <= fastest))
        fail(Exit::bad_input,
             "a wall of axis {} moves at {} nodes a step; at most {} is allowed. Shorten the time step.", name[axis],
             u.norm(), fastest);
      if (u[axis] != 0)
        fail(Exit::bad_input, "a wall of axis {} moves at {} nodes a step along its normal; it may slide only.",
             name[axis], u[axis]);
      if (lattice.periodic[axis] && !u.isZero(0))
        fail(Exit::bad_input, "axis {} is periodic but has a wall that moves; give it walls or no velocity.",
             name[axis]);
    }
}

template void fill_walls(Fluid<float>&);
template void fill_walls(Fluid<double>&);
template void fill_halos(Fluid<float>&);
template void fill_halos(Fluid<double>&);

}  // namespace rouleau
