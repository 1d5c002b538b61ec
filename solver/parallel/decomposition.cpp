// SPDX-License-Identifier: BSD-3-Clause
#include "parallel/decomposition.hpp"

#include <limits>

#include "base/error.hpp"

namespace rouleau {

namespace {

bool fits(const Lattice& lattice, const Int3& ranks) {
  for (int axis = 0; axis < 3; ++axis)
    if (ranks[axis] > 1 && lattice.size[axis] / ranks[axis] < Decomposition::smallest_block) return false;
  return true;
}

/// Nodes on all interfaces; those of cuts across x count four times (they shorten the rows).
double interface(const Lattice& lattice, const Int3& ranks) {
  constexpr std::array<double, 3> weight{4, 1, 1};
  double total = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (ranks[axis] == 1) continue;
    const int cuts = lattice.periodic[axis] ? ranks[axis] : ranks[axis] - 1;
    total += weight[axis] * cuts * static_cast<double>(lattice.nodes()) / lattice.size[axis];
  }
  return total;
}

}  // namespace

Int3 choose_ranks(const Lattice& lattice, int ranks) {
  Int3 best{0, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int x = 1; x <= ranks; ++x) {
    if (ranks % x) continue;
    for (int y = 1; y <= ranks / x; ++y) {
      if ((ranks / x) % y) continue;
      const Int3 cut{x, y, ranks / x / y};
      if (!fits(lattice, cut)) continue;
      if (const double size = interface(lattice, cut); size < least) {
        least = size;
        best = cut;
      }
    }
  }
  return best;
}

Decomposition::Decomposition(const Lattice& lattice, const Communicator& comm, Int3 ranks) : lattice_(lattice) {
  const auto& n = lattice.size;
  if (ranks == Int3{0, 0, 0}) {
    ranks = choose_ranks(lattice, comm.size());
    if (ranks == Int3{0, 0, 0})
      fail(Exit::bad_input,
           "{} x {} x {} nodes cannot be cut into {} blocks of at least {} nodes along each cut axis. Use fewer ranks.",
           n[0], n[1], n[2], comm.size(), smallest_block);
  }
  if (ranks[0] < 1 || ranks[1] < 1 || ranks[2] < 1 || ranks[0] * ranks[1] * ranks[2] != comm.size())
    fail(Exit::bad_input, "--ranks {}x{}x{} needs {} ranks, but {} run. Change --ranks or mpirun's -n.", ranks[0],
         ranks[1], ranks[2], ranks[0] * ranks[1] * ranks[2], comm.size());
  if (!fits(lattice, ranks))
    fail(Exit::bad_input,
         "--ranks {}x{}x{} cuts {} x {} x {} nodes into blocks of fewer than {} nodes along an axis. Use fewer ranks "
         "there.",
         ranks[0], ranks[1], ranks[2], n[0], n[1], n[2], smallest_block);

  ranks_ = ranks;
  position_ = {comm.rank() % ranks[0], comm.rank() / ranks[0] % ranks[1], comm.rank() / (ranks[0] * ranks[1])};
  for (int axis = 0; axis < 3; ++axis) {
    const auto begin = [&](int p) { return static_cast<int>(std::int64_t{n[axis]} * p / ranks[axis]); };
    block_.begin[axis] = begin(position_[axis]);
    block_.size[axis] = begin(position_[axis] + 1) - block_.begin[axis];
  }
}

int Decomposition::neighbour(int axis, int side) const {
  Int3 p = position_;
  p[axis] += side == 0 ? -1 : 1;
  if (p[axis] < 0 || p[axis] >= ranks_[axis]) {
    if (!lattice_.periodic[axis]) return -1;
    p[axis] = (p[axis] + ranks_[axis]) % ranks_[axis];
  }
  return p[0] + ranks_[0] * (p[1] + ranks_[1] * p[2]);
}

}  // namespace rouleau
