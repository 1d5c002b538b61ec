// SPDX-License-Identifier: BSD-3-Clause
// What a run by hand shows on a terminal: one line that is drawn over.
#pragma once

#include <string>

#include "storage/records.hpp"

namespace rouleau {

/// "[####......]  41 %  step 12000 / 29000  4 min 18 s left  20.9 MLUPS  d 0.810 um  checkpoint 31 s ago": as much of
/// it as finds room in so many characters, the bar and the per cent first. Pure; the age is that at `updated_unix_s`.
[[nodiscard]] std::string progress_line(const Progress& progress, std::size_t width);

/// stderr's terminal, if it is one that can be drawn over.
class ProgressBar {
 public:
  /// Nothing is drawn unless `wanted`.
  explicit ProgressBar(bool wanted);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();  ///< ends the line, so that what is said next has one of its own

  [[nodiscard]] bool is_shown() const { return is_shown_; }
  /// Whether it is time to draw it again.
  [[nodiscard]] bool is_due(double now_s) const { return is_shown_ && now_s >= next_s_; }
  void draw(const Progress& progress, double now_s);

 private:
  bool is_shown_, is_drawn_ = false;
  double next_s_ = 0;
};

}  // namespace rouleau
