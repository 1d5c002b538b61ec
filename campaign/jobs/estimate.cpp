// SPDX-License-Identifier: BSD-3-Clause
// Cost arithmetic.
#include "jobs/estimate.hpp"

#include <algorithm>
#include <functional>
#include <queue>

namespace rouleau::campaign {

namespace {

constexpr double bytes_of_sample = 300;  // a line of samples.csv, and about as much again in the database
constexpr double copies_of_sample = 2;
constexpr double bytes_of_progress_line = 100;
constexpr double MiB = 1024.0 * 1024.0;
constexpr double seconds_an_hour = 3600;

}  // namespace

double core_seconds_per_cost(double mlups, int ranks, std::int64_t nodes, double relative_cost) {
  const double seconds_per_step = static_cast<double>(nodes) / (mlups * 1e6);
  return seconds_per_step * ranks / relative_cost;
}

double core_hours(const PlannedPoint& point, double core_seconds_per_cost) {
  return static_cast<double>(point.steps_left) * point.relative_cost_per_step * core_seconds_per_cost / seconds_an_hour;
}

double disk_MiB(const PlannedPoint& point) {
  const double checkpoints = static_cast<double>(point.checkpoint_bytes) * (point.checkpoints_kept + 1);
  const double samples = static_cast<double>(point.samples) * point.cells * bytes_of_sample * copies_of_sample;
  const double progress_lines = point.hours * seconds_an_hour / point.progress_interval_s;
  return (checkpoints + samples + progress_lines * bytes_of_progress_line + static_cast<double>(point.snapshot_bytes)) /
         MiB;
}

double hours_in_all(const std::vector<double>& hours, int jobs) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int job = 0; job < std::max(1, jobs); ++job) free_at.push(0);
  double end = 0;
  for (const double duration : hours) {
    const double start = free_at.top();
    free_at.pop();
    free_at.push(start + duration);
    end = std::max(end, start + duration);
  }
  return end;
}

int jobs_at_a_time(int jobs, int ranks, int cores, bool oversubscribe) {
  const int fitting = std::max(1, cores / ranks);
  if (jobs <= 0) return fitting;
  return oversubscribe ? jobs : std::min(jobs, fitting);
}

}  // namespace rouleau::campaign
