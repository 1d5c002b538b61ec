// SPDX-License-Identifier: BSD-3-Clause
// Cells in all kinds of poses for the tests of the flag lattice.
#pragma once

#include <random>
#include <vector>

#include "base/grid.hpp"
#include "interior/flags.hpp"
#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"
#include "support/blocks.hpp"
#include "support/shell.hpp"

namespace rouleau::testing {

struct Pose {
  Vec3 axis{0, 0, 1};
  double angle = 0;
  Vec3 centre{0, 0, 0};
};

inline Surface posed(Surface surface, const Pose& pose) {
  rotate(surface, pose.axis, pose.angle);
  translate(surface, pose.centre);
  return surface;
}

inline Cells cells_of(const std::vector<Surface>& surfaces) {
  std::vector<CellStart> starts;
  for (const Surface& surface : surfaces) starts.push_back({surface, std::nullopt});
  return assemble(starts);
}

inline Pose random_pose(std::mt19937& random, const Vec3& about, double spread) {
  std::uniform_real_distribution<double> in(-1, 1);
  const Vec3 axis(in(random), in(random), in(random));
  const double angle = 3 * in(random);
  return {axis, angle, about + spread * Vec3(in(random), in(random), in(random))};
}

inline Flags flags_on(const Block& block) { return Flags(block.size, 1); }

/// Fills the halo of flags on the whole lattice; beyond walls stands 1, which must not count.
inline void fill_halo(Flags& flags, const Lattice& lattice) {
  const Flags copy = flags;
  fill(flags, lattice, whole(lattice), std::uint8_t{1}, [&](const Int3& n) { return copy(n[0], n[1], n[2]); });
}

inline std::int64_t differences(const Flags& a, const Flags& b, const Block& block) {
  std::int64_t count = 0;
  for_each_node(block, 0, [&](int i, int j, int k) { count += a(i, j, k) != b(i, j, k); });
  return count;
}

/// Owned nodes where a block's flags differ from those on the whole lattice.
inline std::int64_t differences_on_block(const Flags& part, const Flags& one, const Block& block) {
  std::int64_t count = 0;
  for_each_node(block, 0, [&](int i, int j, int k) {
    count += part(i, j, k) != one(block.begin[0] + i, block.begin[1] + j, block.begin[2] + k);
  });
  return count;
}

/// Nodes among the eight around each vertex, each counted once.
inline std::int64_t shell_nodes(const Cells& cells, const Lattice& lattice) {
  return count_inside(shell_of(cells, lattice));
}

}  // namespace rouleau::testing
