// SPDX-License-Identifier: BSD-3-Clause
// What a campaign will cost: core-hours, wall-clock, disk. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// A point as far as its cost is concerned.
struct PlannedPoint {
  std::int64_t steps_left = 0;
  double relative_cost_per_step = 0;  ///< the solver's; comparable between points
  std::int64_t checkpoint_bytes = 0;
  int checkpoints_kept = 3;
  std::int64_t snapshot_bytes = 0;
  std::int64_t samples = 0;
  int cells = 1;
  double progress_interval_s = 5;
  double hours = 0;  ///< of wall clock from step 0 to the end; 0 = not known
};

/// Core-seconds for a step of relative cost 1: what a measurement gives.
/// `nodes` lattice nodes updated at `mlups` million a second on `ranks` cores, each step costing `relative_cost`.
[[nodiscard]] double core_seconds_per_cost(double mlups, int ranks, std::int64_t nodes, double relative_cost);

[[nodiscard]] double core_hours(const PlannedPoint& point, double core_seconds_per_cost);

/// MiB that the point will take when it is done: kept checkpoints and the one being written, samples, snapshots, and
/// the progress lines in stderr (12 MB a week) if its hours are known.
[[nodiscard]] double disk_MiB(const PlannedPoint& point);

/// Hours until all are done when `jobs` run at a time, each started in order as soon as a place is free.
[[nodiscard]] double hours_in_all(const std::vector<double>& hours, int jobs);

/// Jobs that really run at a time: those asked for (0 = as many as fit), bounded by the cores unless oversubscribed.
[[nodiscard]] int jobs_at_a_time(int jobs, int ranks, int cores, bool oversubscribe);

}  // namespace rouleau::campaign
