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

/// A row beyond a wall has been set at x - c for the owned x; sets the owned node that this leaves out, too: the one a
/// period away from the halo node that was set instead.
template <class Real>
void close_row(Real* row, int c, int size) {
  if (c > 0) row[size - 1] = row[-1];
  if (c < 0) row[0] = row[size];
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
    const Rows<Real> leaving = fluid.f.rows(back), arriving = fluid.f.rows(q);
    for (int k = begin[2]; k < end[2]; ++k)
      for (int j = begin[1]; j < end[1]; ++j) {
        const Real* const from = leaving(j, k);
        Real* const to = arriving(j - c_q[q][1], k - c_q[q][2]) - c_q[q][0];
        for (int i = begin[0]; i < end[0]; ++i) to[i] = from[i] + moving;
        if (fluid.closes_x()) close_row(to + c_q[q][0], c_q[q][0], end[0]);
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
    if (fluid.lattice.periodic[axis] && !(axis == 0 && fluid.closes_x())) fill_periodic(fluid.f, axis);
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
