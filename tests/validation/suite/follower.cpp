// SPDX-License-Identifier: BSD-3-Clause
#include "follower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rouleau::validation {
namespace {

std::string name_of(Tracking variant, std::int64_t interval) {
  constexpr std::array<const char*, 3> names{"vertex normals", "vertex normals, r_shell 2", "face normals"};
  const std::string when = interval == 0 ? "never corrected" : fmt::format("corrected every {} steps", interval);
  return fmt::format("{}, {}", names[static_cast<std::size_t>(variant)], when);
}

/// Copies the flags across the periodic borders; the correction does not ask beyond walls.
void fill_halo(Flags& flags, const Lattice& lattice) {
  const Int3& n = lattice.size;
  for (int k = -1; k <= n[2]; ++k)
    for (int j = -1; j <= n[1]; ++j)
      for (const int i : {-1, n[0]}) flags(i, j, k) = flags(lattice.wrap(0, i), lattice.wrap(1, j), lattice.wrap(2, k));
  for (int k = -1; k <= n[2]; ++k)
    for (const int j : {-1, n[1]})
      for (int i = 0; i < n[0]; ++i) flags(i, j, k) = flags(i, lattice.wrap(1, j), lattice.wrap(2, k));
  for (const int k : {-1, n[2]})
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) flags(i, j, k) = flags(i, j, lattice.wrap(2, k));
}

}  // namespace

void Worst::see(const testing::TrackingDifference& d, bool is_corrected) {
  count_error_sum += static_cast<double>(d.excess) / d.volume;
  ++looks;
  count_error = std::max(count_error, std::abs(static_cast<double>(d.excess)) / d.volume);
  wrong_share = std::max(wrong_share, static_cast<double>(d.wrong) / static_cast<double>(d.shell));
  volume_error = std::max(volume_error, std::abs(d.volume_error()));
  cast_volume_error = std::max(cast_volume_error, std::abs(static_cast<double>(d.inside) / d.volume - 1));
  far_away = std::max(far_away, d.far_away);
  if (is_corrected) far_away_at_correction = std::max(far_away_at_correction, d.far_away);
}

Follower::Follower(Tracking variant, std::int64_t correction_interval, const Lattice& lattice, const Cells& cells)
    : variant_(variant),
      name_(name_of(variant, correction_interval)),
      interval_(correction_interval),
      lattice_(lattice),
      flags_(lattice.size, 1),
      tracker_(variant, lattice, {{0, 0, 0}, lattice.size}, cells),
      correction_(lattice, {{0, 0, 0}, lattice.size}) {
  cast_rays(cells, lattice, {{0, 0, 0}, lattice.size}, RaySearch::columns, flags_);
}

void Follower::follow(const Cells& cells, std::int64_t step) {
  tracker_.update(cells, flags_);
  if (!corrects_at(step)) return;
  fill_halo(flags_, lattice_);
  const Corrections changed = correction_.apply(flags_);
  worst_.flips += changed.activated + changed.deactivated;
  ++worst_.corrections;
}

testing::TrackingDifference Follower::difference(const Cells& cells) const {
  return testing::tracking_difference(flags_, cells, lattice_);
}

}  // namespace rouleau::validation
