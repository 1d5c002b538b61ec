// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/reach.hpp"

#include <algorithm>

namespace rouleau {

ReachAlongX::ReachAlongX(const Lattice& lattice, const Block& block, int halo)
    : lattice_(lattice),
      block_(block),
      halo_(halo),
      is_first_(static_cast<std::size_t>(lattice.size[0])),
      is_reached_(is_first_.size()) {
  runs_.reserve(static_cast<std::size_t>(block.size[0] + 2 * halo));
}

void ReachAlongX::find(const Stencils& stencils) {
  const int n = lattice_.size[0];
  std::ranges::fill(is_first_, std::uint8_t{0});
  std::ranges::fill(is_reached_, std::uint8_t{0});
  for (const std::int32_t first : stencils.first[0])
    is_first_[static_cast<std::size_t>(std::clamp(first, 0, n - 1))] = 1;
  for (int i = 0; i < n; ++i)
    for (int a = 0; a < stencils.width && is_first_[static_cast<std::size_t>(i)] != 0; ++a) {
      const int node = lattice_.wrap(0, i + a);
      if (lattice_.contains(0, node)) is_reached_[static_cast<std::size_t>(node)] = 1;
    }
  runs_.clear();
  for (int i = -halo_; i < block_.size[0] + halo_; ++i) {
    const int node = lattice_.wrap(0, block_.begin[0] + i);
    if (!lattice_.contains(0, node) || is_reached_[static_cast<std::size_t>(node)] == 0) continue;
    if (!runs_.empty() && runs_.back().end == i)
      ++runs_.back().end;
    else
      runs_.push_back({i, i + 1});
  }
}

bool ReachAlongX::reaches_halo() const {
  return !runs_.empty() && (runs_.front().begin < 0 || runs_.back().end > block_.size[0]);
}

}  // namespace rouleau
