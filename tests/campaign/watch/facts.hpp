// SPDX-License-Identifier: BSD-3-Clause
// Campaigns of any size in any state, as `rouleau status --watch` would have read them.
#pragma once

#include "commands/watch_facts.hpp"
#include "study/error.hpp"

namespace rouleau::campaign::testing {

inline constexpr double noon_unix_s = 1.7e9;
inline constexpr std::int64_t end_step = 144000;

inline PointStatus point_at(int ordinal, State state, std::int64_t step) {
  PointStatus s;
  s.point.ordinal = ordinal;
  s.point.key = fmt::format("{:012x}", ordinal);
  s.point.state = state;
  s.point.end_step = end_step;
  s.swept = {1 + 0.25 * ordinal};
  s.step = step;
  s.attempts = state == State::waiting ? 0 : 1;
  return s;
}

/// 500 steps/s since its start, a checkpoint a minute ago.
inline PointStatus running_point(int ordinal, std::int64_t step) {
  PointStatus s = point_at(ordinal, State::running, step);
  s.lives = true;
  s.steps_of_life = step;
  ProgressFile progress;
  progress.attempt = 1;
  progress.step = step;
  progress.steps_per_s = 500;
  progress.mlups = 20.9;
  progress.eta_s = static_cast<double>(end_step - step) / 500;
  progress.checkpoint_step = step - 100;
  progress.checkpoint_unix_s = noon_unix_s - 60;
  progress.d_um = 0.812;
  s.progress = progress;
  return s;
}

inline PointStatus failed_point(int ordinal, State state, const std::string& note) {
  PointStatus s = point_at(ordinal, state, 5000);
  s.note = note;
  return s;
}

inline WatchFacts facts_of(std::vector<PointStatus> points) {
  WatchFacts facts;
  facts.name = "small";
  facts.now_unix_s = noon_unix_s;
  facts.axes = {"fluid.lambda"};
  for (const PointStatus& s : points)
    if (s.step > 0) facts.classes[s.point.key] = "croissant";
  facts.points = std::move(points);
  for (int i = 0; i < 5; ++i)
    facts.changes.push_back({9 - i, noon_unix_s - 10 * i, 2, "running", "done", "exit.json says 0: end time reached"});
  return facts;
}

/// Point 7 of 10 runs, 8 and 9 of 10 wait, the others are done, but for three in trouble in the middle.
inline WatchFacts many(int count) {
  std::vector<PointStatus> points;
  for (int i = 1; i <= count; ++i) {
    if (i % 10 == 7)
      points.push_back(running_point(i, 60000));
    else if (i % 10 >= 8)
      points.push_back(point_at(i, State::waiting, 0));
    else
      points.push_back(point_at(i, State::done, end_step));
  }
  const auto middle = static_cast<std::size_t>(count / 2);
  points[middle] = failed_point(count / 2 + 1, State::failed, "step 5000: velocity is not finite at node (12, 40, 7)");
  points[middle + 1] = failed_point(count / 2 + 2, State::exhausted, "its process is gone and left no exit.json");
  points[middle + 2] = failed_point(count / 2 + 3, State::crashed, "out of memory");
  return facts_of(std::move(points));
}

}  // namespace rouleau::campaign::testing
