// SPDX-License-Identifier: BSD-3-Clause
// The exit code that a campaign's state stands for.
#pragma once

#include "commands/manager.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

/// some_failed if a point of the study failed, was refused or used up its retries, if the campaign is paused, or if a
/// point cannot go on without the user; else ok.
[[nodiscard]] inline Exit outcome_of(const Manager& manager) {
  const StateCounts counts = manager.counts();
  const bool has_failed =
      counts.contains(State::failed) || counts.contains(State::refused) || counts.contains(State::exhausted);
  bool has_unseen = false;
  for (const LivingJob& job : manager.living()) has_unseen = has_unseen || !job.is_seen;
  return has_failed || has_unseen || manager.is_paused() ? Exit::some_failed : Exit::ok;
}

}  // namespace rouleau::campaign
