// SPDX-License-Identifier: BSD-3-Clause
// A study meets a campaign that is there already: which points are new, stay, change or leave. Pure.
#pragma once

#include <string>
#include <vector>

#include "study/expand.hpp"

namespace rouleau::campaign {

/// A point that was in the campaign and is in the study (again).
struct KeptPoint {
  Point before;
  Candidate now;  ///< with the key and ordinal of `before`
};

struct Merge {
  std::vector<Candidate> added;  ///< with key and ordinal
  std::vector<KeptPoint> kept;
  std::vector<Point> dropped;  ///< in the study before, not any more

  /// Steps were added to a point: a finished one must go on.
  [[nodiscard]] static bool has_grown(const KeptPoint& point) {
    return point.now.point.facts.steps > point.before.facts.steps;
  }
};

/// `existing` in the order of their ordinals; new points get the ordinals behind them.
[[nodiscard]] Merge merge(const std::vector<Point>& existing, const Expansion& expansion);

}  // namespace rouleau::campaign
