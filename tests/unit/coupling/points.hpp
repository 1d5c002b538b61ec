// SPDX-License-Identifier: BSD-3-Clause
// Loose vertices for the tests of the coupling: a cell without triangles.
#pragma once

#include <random>
#include <vector>

#include "base/grid.hpp"
#include "membrane/cells.hpp"

namespace rouleau::testing {

inline Cells points(const std::vector<Vec3>& positions) {
  Cells cells;
  const std::size_t n = positions.size();
  for (VectorArray* v : {&cells.X, &cells.U, &cells.U_previous, &cells.F}) v->resize(n);
  for (std::size_t v = 0; v < n; ++v) set(cells.X, v, positions[v]);
  cells.ranges.push_back({0, static_cast<std::int32_t>(n), 0, 0, 0, 0});
  return cells;
}

inline Vec3 random_vector(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> in(low, high);
  const double x = in(random), y = in(random), z = in(random);
  return {x, y, z};
}

/// Positions all over the lattice: dense, up to the walls, on nodes, on walls, and a period outside along periodic
/// axes.
inline std::vector<Vec3> anywhere(const Lattice& lattice, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec3> positions;
  for (int v = 0; v < count; ++v) {
    Vec3 X;
    for (int axis = 0; axis < 3; ++axis) {
      const double n = lattice.size[axis];
      X[axis] = lattice.periodic[axis] ? (3.0 * unit(random) - 1.0) * n : -0.5 + unit(random) * n;
      const double dice = unit(random);
      if (dice < 0.1) X[axis] = std::floor(X[axis]) + (dice < 0.05 ? 0.0 : 0.5);
      if (!lattice.periodic[axis]) {
        if (dice > 0.95) X[axis] = n - 0.5;
        if (dice > 0.975) X[axis] = -0.5;
        X[axis] = std::clamp(X[axis], -0.5, n - 0.5);
      }
    }
    positions.push_back(X);
  }
  return positions;
}

inline void random_forces(Cells& cells, unsigned seed) {
  std::mt19937 random(seed);
  for (std::size_t v = 0; v < cells.vertices(); ++v) set(cells.F, v, random_vector(random, -1, 1));
}

inline Vec3 total(const VectorArray& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < values.size(); ++v) sum += at(values, v);
  return sum;
}

}  // namespace rouleau::testing
