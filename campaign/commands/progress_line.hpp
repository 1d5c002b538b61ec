// SPDX-License-Identifier: BSD-3-Clause
// What `run` shows while it waits: one line that rewrites itself on a terminal, a plain line a minute elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "commands/cli.hpp"
#include "commands/manager.hpp"

namespace rouleau::campaign {

/// Messages and progress on the error stream, without one spoiling the other.
class ProgressLine {
 public:
  ProgressLine(Streams& io, bool quiet) : io_(io), quiet_(quiet) {}

  /// A message of its own line, with the time of day.
  void say(const std::string& message);
  /// Shows where the campaign stands if it is time to.
  void show(const Manager& manager);
  /// Removes the rewriting line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  Streams& io_;
  bool quiet_;
  bool is_shown_ = false;
  Clock::time_point next_{};
};

/// "3 done, 2 running, 7 waiting | #4 41 % 3 min 10 s left, #5 12 % 1 h 02 min left"
[[nodiscard]] std::string progress_text(const Manager& manager);

/// "3 done, 2 running, 7 waiting": the states that occur, finished ones first.
[[nodiscard]] std::string counts_text(const StateCounts& counts);

}  // namespace rouleau::campaign
