// SPDX-License-Identifier: BSD-3-Clause
// Windows, averages and the rule of the class.
#include "report/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/block_average.hpp"
#include "report/oscillation.hpp"
#include "report/tank_treading.hpp"

namespace rouleau::campaign {
namespace {

/// Below this a displacement does not oscillate in any meaning of the word: a hundredth of a lattice node, um.
constexpr double oscillation_floor_um = 0.003;

/// Times are multiples of the time step; a window's end is hit within rounding.
double tolerance(double window_s) { return 1e-9 * window_s; }

/// One measure of one cell over a span of time. `complete` is false when a value in it was not finite.
struct Series {
  std::vector<double> time, value;
  bool complete = true;
};

Series series_of(std::span<const SampleRow> samples, std::optional<double> SampleRow::*measure, double after_s,
                 double until_s) {
  Series series;
  for (const SampleRow& sample : samples) {
    if (sample.time_s <= after_s || sample.time_s > until_s) continue;
    if (const std::optional<double>& value = sample.*measure) {
      series.time.push_back(sample.time_s);
      series.value.push_back(*value);
    } else {
      series.complete = false;
    }
  }
  return series;
}

/// Steps tell more surely than times whether the samples are equally spaced.
bool equally_spaced(std::span<const SampleRow> samples, double after_s) {
  std::optional<std::int64_t> spacing;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i - 1].time_s <= after_s) continue;
    const std::int64_t between = samples[i].step - samples[i - 1].step;
    if (spacing && *spacing != between) return false;
    spacing = between;
  }
  return true;
}

void add_note(ResultRow& result, const std::string& note) { result.note += (result.note.empty() ? "" : "; ") + note; }

/// How d moves: over spans of `length_s`, the last one against the one before.
struct Drift {
  double length_s = 0;
  bool covered = false;  ///< the series reaches back over both spans
  bool finite = false;
  double change_um = 0;
};

Drift drift_of(std::span<const SampleRow> samples, double window_s, std::optional<double> period_s) {
  Drift drift;
  drift.length_s = window_s;
  // A twentieth of a period too short is near enough: 0.2 s need not become two periods of 0.199 s.
  if (period_s) drift.length_s = *period_s * std::max(1.0, std::ceil(window_s / *period_s - 0.05));
  const double end = samples.back().time_s;
  const double after = end - drift.length_s + tolerance(drift.length_s);
  const double after_previous = end - 2 * drift.length_s + tolerance(drift.length_s);
  const Series last = series_of(samples, &SampleRow::d_um, after, end);
  const Series previous = series_of(samples, &SampleRow::d_um, after_previous, after);
  drift.covered = samples.front().time_s <= after_previous && !last.value.empty() && !previous.value.empty();
  drift.finite = last.complete && previous.complete;
  if (drift.covered && drift.finite)
    drift.change_um = block_average(last.value).mean - block_average(previous.value).mean;
  return drift;
}

void classify(ResultRow& result, const Analysis& settings, const Drift& drift) {
  result.phase = "undecided";
  if (!drift.finite || !result.d_mean_um) {
    result.phase_reason = "a displacement in the window or the window before is not finite";
    return;
  }
  if (!drift.covered) {
    result.phase_reason = fmt::format(
        "the series does not cover two windows of {:.4g} s, so it cannot be called settled", drift.length_s);
    return;
  }
  result.d_change_um = drift.change_um;
  const double d = *result.d_mean_um;
  const double change = drift.change_um;
  if (d <= settings.croissant_d_um) {
    const bool rising = change > settings.drift_um;
    if (!rising) result.phase = "croissant";
    result.phase_reason =
        fmt::format("mean d {:.4g} um <= {} um, {} by {:.4g} um from the window before (limit {} um)", d,
                    settings.croissant_d_um, rising ? "but risen" : "changed", change, settings.drift_um);
  } else if (d >= settings.slipper_d_um) {
    const bool falling = -change > settings.drift_um;
    if (!falling) result.phase = "slipper";
    result.phase_reason = fmt::format("mean d {:.4g} um >= {} um, {} by {:.4g} um from the window before (limit {} um)",
                                      d, settings.slipper_d_um, falling ? "but fallen" : "changed",
                                      falling ? -change : change, settings.drift_um);
  } else {
    result.phase_reason =
        fmt::format("mean d {:.4g} um lies between {} and {} um", d, settings.croissant_d_um, settings.slipper_d_um);
  }
}

ResultRow analyse_cell(std::string_view point, std::span<const SampleRow> samples, const Analysis& settings) {
  ResultRow result;
  result.point = point;
  result.cell = samples.front().cell;
  result.window_s = settings.window_s;
  result.time_s = samples.back().time_s;
  result.step = samples.back().step;

  const double window = settings.window_s, end = result.time_s, begin = samples.front().time_s;
  const double after = end - window + tolerance(window);
  const Series d = series_of(samples, &SampleRow::d_um, after, end);
  const Series asphericity = series_of(samples, &SampleRow::asphericity, after, end);
  result.samples = std::count_if(samples.begin(), samples.end(), [&](const SampleRow& s) { return s.time_s > after; });
  const auto first = std::find_if(samples.begin(), samples.end(), [&](const SampleRow& s) { return s.time_s > after; });
  result.window_start_s = first->time_s;  // the last sample lies in the window, so there is one

  if (begin > after)
    add_note(result, fmt::format("the series covers {:.4g} s of the window of {} s", end - begin, window));
  if (!equally_spaced(samples, after))
    add_note(result, "the samples are not equally spaced: means weigh samples, not time");
  if (d.complete && !d.value.empty()) {
    const BlockAverage average = block_average(d.value);
    result.d_mean_um = average.mean;
    result.d_error_um = average.error;
    if (!average.error)
      add_note(result, fmt::format("no error from {} samples", d.value.size()));
    else if (!average.converged)
      add_note(result, "the error of d is a lower bound: d is correlated over much of the window");
  } else {
    add_note(result, "a displacement in the window is not finite");
  }
  if (asphericity.complete && !asphericity.value.empty()) {
    const BlockAverage average = block_average(asphericity.value);
    result.asphericity_mean = average.mean;
    result.asphericity_error = average.error;
  } else {
    add_note(result, "an asphericity in the window is not finite");
  }

  const double span = std::max(window, std::min(settings.oscillation_window_s, 0.5 * (end - begin)));
  const Series wave = series_of(samples, &SampleRow::d_um, end - span + tolerance(span), end);
  if (wave.complete) {
    const Oscillation oscillation = find_oscillation(wave.time, wave.value, oscillation_floor_um);
    result.d_amplitude_um = oscillation.amplitude;
    result.d_period_s = oscillation.period;
  }
  const TankTreading turning = tank_treading(samples, end - span + tolerance(span));
  result.tank_treading_per_s = turning.per_s;
  result.tank_treading_error_per_s = turning.error_per_s;
  result.tank_treading_reason = turning.reason;
  classify(result, settings, drift_of(samples, window, result.d_period_s));
  return result;
}

}  // namespace

std::vector<ResultRow> analyse(std::string_view point, std::span<const SampleRow> samples, const Analysis& settings) {
  std::map<int, std::vector<SampleRow>> cells;
  for (const SampleRow& sample : samples) cells[sample.cell].push_back(sample);
  std::vector<ResultRow> results;
  for (const auto& [cell, of_cell] : cells) results.push_back(analyse_cell(point, of_cell, settings));
  return results;
}

}  // namespace rouleau::campaign
