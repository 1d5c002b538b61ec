// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/advect.hpp"

#include "coupling/positions.hpp"

namespace rouleau {
namespace {

struct Step {
  double now, before;  ///< X += now U + before U_previous
};

Step coefficients(Advection scheme) { return scheme == Advection::euler ? Step{1.0, 0.0} : Step{1.5, -0.5}; }

/// Moves one coordinate of one vertex; returns whether it is still on the lattice.
bool move(const Step& step, const PositionRange& range, double U, double& U_previous, double& X) {
  if (step.before == 0.0) {
    X += U;
  } else {
    X += step.now * U + step.before * U_previous;
    U_previous = U;
  }
  return range.contains(X);
}

template <class VertexOf>
void advect_each(Cells& cells, std::size_t count, VertexOf vertex_of, Advection scheme, const Lattice& lattice) {
  const Step step = coefficients(scheme);
  const PositionRange x(lattice, 0), y(lattice, 1), z(lattice, 2);
  bool all_inside = true;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t v = vertex_of(i);
    all_inside &= move(step, x, cells.U.x[v], cells.U_previous.x[v], cells.X.x[v]);
    all_inside &= move(step, y, cells.U.y[v], cells.U_previous.y[v], cells.X.y[v]);
    all_inside &= move(step, z, cells.U.z[v], cells.U_previous.z[v], cells.X.z[v]);
  }
  if (!all_inside) check_positions(cells, lattice);
}

}  // namespace

void advect(Cells& cells, std::span<const std::int32_t> vertices, Advection scheme, const Lattice& lattice) {
  advect_each(
      cells, vertices.size(), [&](std::size_t i) { return static_cast<std::size_t>(vertices[i]); }, scheme, lattice);
}

void advect(Cells& cells, Advection scheme, const Lattice& lattice) {
  advect_each(
      cells, cells.vertices(), [](std::size_t i) { return i; }, scheme, lattice);
}

void start_history(Cells& cells) {
  cells.U_previous.x = cells.U.x;
  cells.U_previous.y = cells.U.y;
  cells.U_previous.z = cells.U.z;
}

}  // namespace rouleau
