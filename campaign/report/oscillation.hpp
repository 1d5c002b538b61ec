// SPDX-License-Identifier: BSD-3-Clause
// Amplitude and period of a series that may oscillate.
#pragma once

#include <optional>
#include <span>

namespace rouleau::campaign {

struct Oscillation {
  std::optional<double> amplitude;  ///< unset below eight values
  std::optional<double> period;     ///< unset when the series shows no regular oscillation
};

/// The straight line that fits best is taken off first.
/// amplitude  sqrt(2) times the standard deviation of the rest: that of a sine with the same power
/// period     mean time between crossings of zero in the same direction. A crossing counts only once the rest has left
/// the band
///            of a quarter of the amplitude, so noise is not counted. Given only from at least two such
///            times that deviate from their mean by no more than a quarter of it, and an amplitude above `floor`.
/// time, value  of the same length, times ascending, all finite
Oscillation find_oscillation(std::span<const double> time, std::span<const double> value, double floor);

}  // namespace rouleau::campaign
