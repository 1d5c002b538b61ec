// SPDX-License-Identifier: BSD-3-Clause
// Two ranks that measure by turns: one alone while the other sleeps, or both together.
#pragma once

#include "parallel/communicator.hpp"

namespace rouleau::speed {

class Pair {
 public:
  /// Pins each rank to a core of its own if there are enough, as the campaign manager pins its jobs.
  /// throws  Error(usage) unless there are two ranks
  explicit Pair(const Communicator& both);

  [[nodiscard]] bool is_first() const { return both_.is_root(); }

  /// Runs `work` on rank 0 while rank 1 sleeps.
  template <class Work>
  void first_alone(const Work& work) const {
    if (is_first()) work();
    meet();
  }
  /// Both leave at the same moment.
  void start_together() const {
    meet();
    both_.barrier();
  }

 private:
  /// Waits for the other rank asleep: a rank that spins would take its share of caches, memory and clock rate.
  void meet() const;

  const Communicator& both_;
};

}  // namespace rouleau::speed
