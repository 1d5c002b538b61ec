// SPDX-License-Identifier: BSD-3-Clause
// Angles made continuous, whole turns counted.
#include "report/tank_treading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace rouleau::campaign {
namespace {

using Measure = std::optional<double> SampleRow::*;

/// What is looked at in one plane.
struct Plane {
  const char* name;
  Measure marker_x, marker_across, axis_deg;
};
constexpr Plane planes[] = {
    {"x-z", &SampleRow::marker_z_dx_um, &SampleRow::marker_z_dz_um, &SampleRow::angle_xz_deg},
    {"x-y", &SampleRow::marker_y_dx_um, &SampleRow::marker_y_dy_um, &SampleRow::angle_xy_deg},
};

/// The angle of the marker from the cell's axis, continuous in time, in turns.
struct Path {
  std::vector<double> time, turns;
  std::string trouble;  ///< why it cannot be followed; empty: it can

  [[nodiscard]] double total() const { return turns.empty() ? 0 : turns.back() - turns.front(); }
};

/// `difference` brought to [-period / 2, period / 2].
double wrapped(double difference, double period) { return difference - period * std::round(difference / period); }

Path path_in(const Plane& plane, std::span<const SampleRow> samples, double after_s) {
  constexpr double widest_marker_step = 1.0 / 3, widest_axis_step = 1.0 / 6;  // turns
  Path path;
  double marker = 0, axis = 0;
  for (const SampleRow& sample : samples) {
    if (sample.time_s <= after_s) continue;
    const std::optional<double>&x = sample.*plane.marker_x, &across = sample.*plane.marker_across;
    const std::optional<double>& axis_deg = sample.*plane.axis_deg;
    if (!x || !across || !axis_deg) {
      path.trouble = sample.finite ? "the samples have no markers: they are those of an older solver"
                                   : "a marker in the window is not finite";
      return path;
    }
    const double marker_now = std::atan2(*across, *x) / (2 * std::numbers::pi), axis_now = *axis_deg / 360;
    if (path.time.empty()) {
      marker = marker_now;
      axis = axis_now;
    }
    const double marker_step = wrapped(marker_now - marker, 1), axis_step = wrapped(axis_now - axis, 0.5);
    if (std::abs(marker_step) > widest_marker_step || std::abs(axis_step) > widest_axis_step) {
      path.trouble = fmt::format("the samples around {:.6g} s lie too far apart to follow the turns", sample.time_s);
      return path;
    }
    marker += marker_step;
    axis += axis_step;
    path.time.push_back(sample.time_s);
    path.turns.push_back(marker - axis);
  }
  return path;
}

/// When the path was so many turns from its end, for the last time.
double time_before_end(const Path& path, double turns) {
  const double end = path.turns.back(), sign = path.total() < 0 ? -1 : 1;
  const auto lag = [&](std::size_t i) { return sign * (end - path.turns[i]); };
  for (std::size_t i = path.time.size() - 1; i > 0; --i)
    if (lag(i) < turns && lag(i - 1) >= turns)
      return path.time[i] - (path.time[i] - path.time[i - 1]) * (turns - lag(i)) / (lag(i - 1) - lag(i));
  return path.time.front();
}

TankTreading whole_turns(const Path& path, const char* plane) {
  TankTreading result;
  const double total = std::abs(path.total());
  if (total < 1) {
    result.reason = fmt::format("less than one turn: {:.2g} in {:.4g} s", total,
                                path.time.empty() ? 0.0 : path.time.back() - path.time.front());
    return result;
  }
  const double whole = std::floor(total);
  double later = path.time.back(), squares = 0;
  for (double turn = 1; turn <= whole; ++turn) {
    const double earlier = time_before_end(path, turn);
    const double rate = 1 / (later - earlier);
    squares += rate * rate;
    later = earlier;
  }
  const double span = path.time.back() - later;
  result.per_s = whole / span;
  if (whole >= 2) {
    // Deviations are taken from the given frequency, which is the mean over time, not over turns.
    const double variance = std::max(0.0, squares / whole - *result.per_s * *result.per_s) * whole / (whole - 1);
    result.error_per_s = std::sqrt(variance / whole);
  }
  result.reason = fmt::format("{:.0f} turn{} in the {} plane, in {:.4g} s", whole, whole > 1 ? "s" : "", plane, span);
  return result;
}

}  // namespace

TankTreading tank_treading(std::span<const SampleRow> samples, double after_s) {
  const Plane* best = nullptr;
  Path best_path;
  std::string trouble;
  for (const Plane& plane : planes) {
    Path path = path_in(plane, samples, after_s);
    if (!path.trouble.empty()) {
      if (trouble.empty()) trouble = path.trouble;
      continue;
    }
    if (best != nullptr && std::abs(path.total()) <= std::abs(best_path.total())) continue;
    best = &plane;
    best_path = std::move(path);
  }
  if (best == nullptr) return {std::nullopt, std::nullopt, trouble};
  TankTreading result = whole_turns(best_path, best->name);
  if (!result.per_s && !trouble.empty()) result.reason += "; in the other plane " + trouble;
  return result;
}

}  // namespace rouleau::campaign
