// SPDX-License-Identifier: BSD-3-Clause
// How a flag lattice that followed the membrane differs from one that is cast anew.
#pragma once

#include <cstdint>

#include "interior/ray_cast.hpp"
#include "membrane/volume.hpp"
#include "support/shell.hpp"

namespace rouleau::testing {

struct TrackingDifference {
  std::int64_t shell = 0;     ///< nodes among the eight around each vertex, each once
  std::int64_t wrong = 0;     ///< nodes that differ from ray casting
  std::int64_t far_away = 0;  ///< of them, farther than two nodes from every vertex: a tail, or a hole
  std::int64_t excess = 0;    ///< inside nodes more than by ray casting
  std::int64_t inside = 0;    ///< by ray casting
  double volume = 0;          ///< of the meshes

  /// N_in / V - 1
  [[nodiscard]] double volume_error() const { return static_cast<double>(inside + excess) / volume - 1; }
};

inline double squared_distance(const Lattice& lattice, const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double d = a[axis] - b[axis];
    if (lattice.periodic[axis]) d -= lattice.size[axis] * std::round(d / lattice.size[axis]);
    sum += d * d;
  }
  return sum;
}

/// `tracked(i, j, k)` is 1 inside, 0 outside, of a lattice in one block.
template <class Tracked>
TrackingDifference tracking_difference(const Tracked& tracked, const Cells& cells, const Lattice& lattice) {
  Flags cast(lattice.size, 1);
  cast_rays(cells, lattice, {{0, 0, 0}, lattice.size}, RaySearch::columns, cast);
  TrackingDifference difference;
  difference.shell = count_inside(shell_of(cells, lattice));
  for (std::size_t c = 0; c < cells.ranges.size(); ++c) difference.volume += volume(cells, c);
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i) {
        const int is = tracked(i, j, k), should_be = cast(i, j, k);
        difference.inside += should_be;
        difference.excess += is - should_be;
        if (is == should_be) continue;
        ++difference.wrong;
        bool is_near = false;
        for (std::size_t v = 0; v < cells.vertices() && !is_near; ++v)
          is_near = squared_distance(lattice, Vec3(i, j, k), at(cells.X, v)) <= 4;
        difference.far_away += !is_near;
      }
  return difference;
}

}  // namespace rouleau::testing
