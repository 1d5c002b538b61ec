// SPDX-License-Identifier: BSD-3-Clause
// Which points to start now: within the jobs, the cores and the pauses that are allowed. Pure.
#pragma once

#include <string>
#include <vector>

#include "jobs/state.hpp"

namespace rouleau::campaign {

/// A point as the scheduler sees it.
struct Startable {
  std::string key;
  int ordinal = 0;
  State state = State::waiting;
  bool in_study = true;
  bool has_live_process = false;  ///< also of a cancelled point that is still stopping
  double retry_at_unix_s = 0;
};

struct Capacity {
  int jobs = 1;        ///< at a time
  int free_cores = 1;  ///< not used by living jobs
  int ranks = 1;       ///< cores that a job takes
  bool oversubscribe = false;
};

/// Keys to start now, in order: interrupted points before new ones (their results come first), each group by ordinal.
/// Points that left the study, that are final, that live, or whose pause is not over are passed by.
[[nodiscard]] std::vector<std::string> choose_starts(const std::vector<Startable>& points, const Capacity& capacity,
                                                     double now_unix_s);

/// The earliest end of a pause among the points that wait for nothing else; 0 = there is none.
[[nodiscard]] double next_retry(const std::vector<Startable>& points, double now_unix_s);

/// Whether a further `run` has anything to do: something lives or can be started, now or later.
[[nodiscard]] bool has_work(const std::vector<Startable>& points);

}  // namespace rouleau::campaign
