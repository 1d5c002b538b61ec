// SPDX-License-Identifier: BSD-3-Clause
// How long each part of the step takes.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace rouleau {

/// The verbs of a step, in their order.
enum class Part {
  stencils,
  forces,
  spread,
  collide,
  halos,
  interpolate,
  advect,
  volume,
  tracking,
  correction,
  control,
  count
};

inline constexpr std::array<const char*, static_cast<std::size_t>(Part::count)> part_names{
    "stencils", "forces", "spread",   "collide-stream", "halos",  "interpolate",
    "advect",   "volume", "tracking", "correction",     "control"};

/// Adds up the time between laps.
class StepTimers {
 public:
  void start() { last_ = Clock::now(); }
  /// The time since the last lap (or start) was spent on `part`.
  void lap(Part part) {
    const auto now = Clock::now();
    spent_[static_cast<std::size_t>(part)] += now - last_;
    last_ = now;
  }
  [[nodiscard]] double seconds(Part part) const {
    return std::chrono::duration<double>(spent_[static_cast<std::size_t>(part)]).count();
  }
  void reset() { spent_.fill({}); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_{};
  std::array<Clock::duration, static_cast<std::size_t>(Part::count)> spent_{};
};

}  // namespace rouleau
