// SPDX-License-Identifier: BSD-3-Clause
// At which steps something happens that is wanted at equal intervals of physical time.
#pragma once

#include <cmath>
#include <cstdint>

namespace rouleau {

/// The steps nearest to the multiples of an interval that need not be a whole number of steps: step 0 first, no drift,
/// the same steps wherever a run starts.
class StepSchedule {
 public:
  /// `interval` in steps, at least 1; 0: never
  explicit StepSchedule(double interval) : interval_(interval) {}

  [[nodiscard]] bool is_due(std::int64_t step) const {
    return interval_ > 0 && step_of(std::llround(static_cast<double>(step) / interval_)) == step;
  }
  /// How many of the steps 0 ... `last` are due.
  [[nodiscard]] std::int64_t count(std::int64_t last) const {
    if (!(interval_ > 0)) return 0;
    std::int64_t n = std::llround(static_cast<double>(last) / interval_);
    while (step_of(n) > last) --n;
    return n + 1;
  }
  /// The n-th one, n = 0, 1, ...
  [[nodiscard]] std::int64_t step_of(std::int64_t n) const { return std::llround(static_cast<double>(n) * interval_); }

 private:
  double interval_;
};

}  // namespace rouleau
