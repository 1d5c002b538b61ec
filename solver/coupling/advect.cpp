// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/advect.hpp"

#include "coupling/positions.hpp"

namespace rouleau {
namespace {

struct Step {
  double now, before;  ///< X += now U + before U_previous
};

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
  const Step step = scheme == Advection::euler ? Step{1.0, 0.0} : Step{1.5, -0.5};
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
