// SPDX-License-Identifier: BSD-3-Clause
// The scheduler's choice.
#include "jobs/schedule.hpp"

#include <algorithm>

namespace rouleau::campaign {

namespace {

bool can_start(const Startable& point) {
  return point.in_study && !point.has_live_process &&
         (point.state == State::waiting || point.state == State::stopped || point.state == State::crashed);
}

}  // namespace

std::vector<std::string> choose_starts(const std::vector<Startable>& points, const Capacity& capacity,
                                       double now_unix_s) {
  const auto living =
      std::count_if(points.begin(), points.end(), [](const Startable& p) { return p.has_live_process; });
  std::vector<const Startable*> ready;
  for (const Startable& point : points) {
    if (can_start(point) && point.retry_at_unix_s <= now_unix_s) ready.push_back(&point);
  }
  std::stable_sort(ready.begin(), ready.end(), [](const Startable* a, const Startable* b) {
    const bool a_is_new = a->state == State::waiting;
    const bool b_is_new = b->state == State::waiting;
    return a_is_new != b_is_new ? b_is_new : a->ordinal < b->ordinal;
  });
  std::vector<std::string> starts;
  int jobs_left = capacity.jobs - static_cast<int>(living);
  int cores_left = capacity.free_cores;
  for (const Startable* point : ready) {
    if (jobs_left <= 0 || (!capacity.oversubscribe && cores_left < capacity.ranks)) break;
    starts.push_back(point->key);
    --jobs_left;
    cores_left -= capacity.ranks;
  }
  return starts;
}

double next_retry(const std::vector<Startable>& points, double now_unix_s) {
  double next = 0;
  for (const Startable& point : points) {
    if (!can_start(point) || point.retry_at_unix_s <= now_unix_s) continue;
    if (next == 0 || point.retry_at_unix_s < next) next = point.retry_at_unix_s;
  }
  return next;
}

bool has_work(const std::vector<Startable>& points) {
  return std::any_of(points.begin(), points.end(),
                     [](const Startable& point) { return point.has_live_process || can_start(point); });
}

}  // namespace rouleau::campaign
