// SPDX-License-Identifier: BSD-3-Clause
// The circuit breaker: points that fail early and alike, one after another, mean that something common is wrong.
#pragma once

#include <set>
#include <string>

namespace rouleau::campaign {

/// Counts different points in a row whose attempts ended without progress for the same reason. Once it has tripped it
/// stays as it is, whatever becomes of the jobs that still run, until it is reset.
class Breaker {
 public:
  /// Trips at `limit` points; 0 = never. `kept`: what `text` gave, so that passes of different processes count as one.
  explicit Breaker(int limit, const std::string& kept = "");

  /// The failures counted so far: the reason, a newline, the points.
  [[nodiscard]] std::string text() const;

  /// An attempt of `point` ended badly without progress. Numbers in the reason (steps, places) do not make it another
  /// one.
  void note_failure(const std::string& point, const std::string& reason);
  /// An attempt of any point made progress.
  void note_progress();
  /// The user has corrected the common cause.
  void reset();

  [[nodiscard]] bool has_tripped() const { return limit_ > 0 && static_cast<int>(points_.size()) >= limit_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }

 private:
  int limit_;
  std::set<std::string> points_;
  std::string reason_;  ///< of the last failure, as given
  std::string shape_;   ///< the same without its numbers
};

}  // namespace rouleau::campaign
