// SPDX-License-Identifier: BSD-3-Clause
// A flag lattice of its own that follows the cells of a simulation: what another variant would have made of them.
#pragma once

#include <string>

#include "../tracking_difference.hpp"
#include "interior/correction.hpp"
#include "interior/tracker.hpp"

namespace rouleau::validation {

/// The largest differences from ray casting seen so far, and their mean.
struct Worst {
  double count_error = 0;                   ///< |inside nodes minus those of ray casting| / V
  double wrong_share = 0;                   ///< wrong nodes over nodes of the shell
  double volume_error = 0;                  ///< |N_in / V - 1|
  double cast_volume_error = 0;             ///< the same of ray casting: what counting nodes costs
  std::int64_t far_away = 0;                ///< nodes farther than two nodes from the membrane
  std::int64_t far_away_at_correction = 0;  ///< right after a correction
  std::int64_t flips = 0;                   ///< flags that corrections have changed, all together
  std::int64_t corrections = 0;
  double count_error_sum = 0;  ///< signed
  std::int64_t looks = 0;

  void see(const testing::TrackingDifference& difference, bool is_corrected);
  [[nodiscard]] double mean_count_error() const { return count_error_sum / static_cast<double>(looks); }
};

class Follower {
 public:
  /// Starts with flags cast by rays. `correction_interval` in steps; 0: never.
  Follower(Tracking variant, std::int64_t correction_interval, const Lattice& lattice, const Cells& cells);

  /// After a step: moves the flags on, and corrects them if it is time.
  void follow(const Cells& cells, std::int64_t step);
  /// From ray casting.
  [[nodiscard]] testing::TrackingDifference difference(const Cells& cells) const;
  /// Remembers the worst.
  void look(const Cells& cells, std::int64_t step) { worst_.see(difference(cells), corrects_at(step)); }

  [[nodiscard]] Tracking variant() const { return variant_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Worst& worst() const { return worst_; }

 private:
  [[nodiscard]] bool corrects_at(std::int64_t step) const { return interval_ != 0 && step % interval_ == 0; }

  Tracking variant_;
  std::string name_;
  std::int64_t interval_;
  Lattice lattice_;
  Flags flags_;
  Tracker tracker_;
  Correction correction_;
  Worst worst_;
};

}  // namespace rouleau::validation
