// SPDX-License-Identifier: BSD-3-Clause
#include "ray_times.hpp"

#include "interior/ray_cast.hpp"
#include "stopwatch.hpp"

namespace rouleau::speed {

double full_cast_seconds(const Cells& cells, const Lattice& lattice, int planes) {
  const Int3 plane{lattice.size[0], lattice.size[1], 1};
  Flags flags(plane, 1);
  double seconds = 0;
  for (int p = 0; p < planes; ++p) {
    const Block block{{0, 0, (2 * p + 1) * lattice.size[2] / (2 * planes)}, plane};
    seconds += seconds_of([&] { cast_rays(cells, lattice, block, RaySearch::direct, flags); });
  }
  return seconds * lattice.size[2] / planes;
}

double column_cast_seconds(const Cells& cells, const Lattice& lattice, double enough_s) {
  const Block all{{0, 0, 0}, lattice.size};
  Flags flags(lattice.size, 1);
  return seconds_per_call(enough_s, [&] { cast_rays(cells, lattice, all, RaySearch::columns, flags); });
}

double shell_cast_seconds(const Cells& cells, const Lattice& lattice, double enough_s) {
  const Block all{{0, 0, 0}, lattice.size};
  Flags flags(lattice.size, 1);
  return seconds_per_call(enough_s, [&] { cast_rays_near_membrane(cells, lattice, all, RaySearch::direct, flags); });
}

}  // namespace rouleau::speed
