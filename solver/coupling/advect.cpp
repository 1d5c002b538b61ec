// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/advect.hpp"

#include "coupling/positions.hpp"

namespace rouleau {
namespace {

struct Step {
  double now, before;  ///< X += now U + before U_previous
};

/// [Zanetti1989] Zanetti, Phys Rev A 40 (1989) 1539: a plane of nodes hands all of its momentum along its normal to its
/// two neighbours in each step, so the sum of (-1)^(x+t) j_x over the lattice, likewise in y and z, is kept for ever.
/// Under Euler's scheme a membrane that answers this mode with a stiffness k, seen through the kernel, feeds it: with
/// j' = -(j + F), u = j + F/2, F = -kX its factor a step is -(1 + k/2), unstable for any k > 0
/// (studies/safe-combinations). The mean of two steps does not see it: the factors are 1 and -k/4. The 4-point kernel
/// gives even and odd nodes equal weights and does not see it either.
Step step_of(Advection scheme) {
  switch (scheme) {
    case Advection::euler:
      break;
    case Advection::adams_bashforth:
      return {1.5, -0.5};
    case Advection::averaged:
      return {0.5, 0.5};
  }
  return {1.0, 0.0};
}

/// Moves one coordinate of all vertices; returns whether all are still on the lattice.
bool move(const Step& step, const PositionRange& range, const Array<double>& velocity, Array<double>& velocity_before,
          Array<double>& position) {
  const double* const U = velocity.data();
  double* const U_previous = velocity_before.data();
  double* const X = position.data();
  double outside = 0;
#pragma omp simd reduction(+ : outside)
  for (std::size_t v = 0; v < position.size(); ++v) {
    X[v] += step.now * U[v] + step.before * U_previous[v];
    U_previous[v] = U[v];
    outside += range.contains(X[v]) ? 0.0 : 1.0;
  }
  return outside == 0.0;
}

}  // namespace

void advect(Cells& cells, Advection scheme, const Lattice& lattice) {
  const Step step = step_of(scheme);
  const bool x = move(step, {lattice, 0}, cells.U.x, cells.U_previous.x, cells.X.x);
  const bool y = move(step, {lattice, 1}, cells.U.y, cells.U_previous.y, cells.X.y);
  const bool z = move(step, {lattice, 2}, cells.U.z, cells.U_previous.z, cells.X.z);
  if (!(x && y && z)) check_positions(cells, lattice);
}

void start_history(Cells& cells) {
  cells.U_previous.x = cells.U.x;
  cells.U_previous.y = cells.U.y;
  cells.U_previous.z = cells.U.z;
}

}  // namespace rouleau
