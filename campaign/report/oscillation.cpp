// SPDX-License-Identifier: BSD-3-Clause
// Detrending and counting of crossings.
#include "report/oscillation.hpp"

#include <cmath>
#include <vector>

#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

std::vector<double> detrended(std::span<const double> time, std::span<const double> value) {
  const double n = static_cast<double>(value.size());
  double t_mean = 0, v_mean = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    t_mean += time[i];
    v_mean += value[i];
  }
  t_mean /= n;
  v_mean /= n;
  double tt = 0, tv = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    tt += (time[i] - t_mean) * (time[i] - t_mean);
    tv += (time[i] - t_mean) * (value[i] - v_mean);
  }
  const double slope = tt > 0 ? tv / tt : 0;
  std::vector<double> rest(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) rest[i] = value[i] - v_mean - slope * (time[i] - t_mean);
  return rest;
}

/// Times at which the rest crosses zero upwards (direction +1) or downwards (-1) on its way from one side of the band
/// to the other.
std::vector<double> crossings(std::span<const double> time, std::span<const double> rest, double band, int direction) {
  std::vector<double> times;
  bool armed = false;
  double crossing = 0;  // the last one on the way up; there is one whenever the other side is reached
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double now = direction * rest[i];
    if (armed && i > 0) {
      const double before = direction * rest[i - 1];
      if (before <= 0 && now > 0) crossing = time[i - 1] + (time[i] - time[i - 1]) * (-before / (now - before));
    }
    if (now < -band) {
      armed = true;
    } else if (now > band && armed) {
      times.push_back(crossing);
      armed = false;
    }
  }
  return times;
}

}  // namespace

Oscillation find_oscillation(std::span<const double> time, std::span<const double> value, double floor) {
  require(time.size() == value.size(), "a series has as many times as values");
  constexpr std::size_t fewest_values = 8;
  constexpr double widest_spread = 0.25;
  Oscillation found;
  if (value.size() < fewest_values) return found;

  const std::vector<double> rest = detrended(time, value);
  double squares = 0;
  for (const double r : rest) squares += r * r;
  found.amplitude = std::sqrt(2 * squares / static_cast<double>(rest.size()));
  if (*found.amplitude <= floor) return found;

  std::vector<double> intervals;
  for (const int direction : {+1, -1}) {
    const std::vector<double> times = crossings(time, rest, 0.25 * *found.amplitude, direction);
    for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  }
  if (intervals.size() < 2) return found;
  double mean = 0;
  for (const double interval : intervals) mean += interval;
  mean /= static_cast<double>(intervals.size());
  for (const double interval : intervals)
    if (std::abs(interval - mean) > widest_spread * mean) return found;
  found.period = mean;
  return found;
}

}  // namespace rouleau::campaign
