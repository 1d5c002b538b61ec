// SPDX-License-Identifier: BSD-3-Clause
// Amplitude and period of waves that are known.
#include "report/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace rouleau::campaign {
namespace {

constexpr double tau = 2 * std::numbers::pi;
constexpr double floor_um = 0.003;

struct Wave {
  std::vector<double> time, value;

  template <class Function>
  Wave(double duration, std::size_t n, Function&& function) {
    for (std::size_t i = 0; i < n; ++i) {
      time.push_back(duration * static_cast<double>(i) / static_cast<double>(n));
      value.push_back(function(time.back()));
    }
  }
};

TEST(Oscillation, SineHasItsAmplitudeAndPeriod) {
  const Wave wave(1.0, 2000, [](double t) { return 0.8 + 0.1 * std::sin(tau * t / 0.2 + 0.3); });
  const Oscillation found = find_oscillation(wave.time, wave.value, floor_um);
  EXPECT_NEAR(*found.amplitude, 0.1, 0.003);  // the line taken off a few periods carries 1 to 2 % of the wave
  EXPECT_NEAR(*found.period, 0.2, 0.002);
}

TEST(Oscillation, DriftIsTakenOff) {
  const Wave wave(1.0, 2000, [](double t) { return 0.8 + 0.5 * t + 0.1 * std::sin(tau * t / 0.2); });
  const Oscillation found = find_oscillation(wave.time, wave.value, floor_um);
  EXPECT_NEAR(*found.amplitude, 0.1, 0.005);
  EXPECT_NEAR(*found.period, 0.2, 0.005);
}

TEST(Oscillation, NoiseOnAWaveDoesNotShortenItsPeriod) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  const Wave wave(1.0, 2000, [&](double t) { return 0.1 * std::sin(tau * t / 0.2) + noise(random); });
  EXPECT_NEAR(*find_oscillation(wave.time, wave.value, floor_um).period, 0.2, 0.005);
}

TEST(Oscillation, NoiseAloneHasNoPeriod) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  const Wave wave(1.0, 2000, [&](double) { return noise(random); });
  EXPECT_EQ(find_oscillation(wave.time, wave.value, floor_um).period, std::nullopt);
}

TEST(Oscillation, DecayHasNoPeriod) {
  const Wave wave(1.0, 500, [](double t) { return std::exp(-5 * t); });
  EXPECT_EQ(find_oscillation(wave.time, wave.value, floor_um).period, std::nullopt);
}

TEST(Oscillation, SinglePeriodIsNotEnough) {
  const Wave wave(0.2, 500, [](double t) { return 0.1 * std::sin(tau * t / 0.2); });
  EXPECT_EQ(find_oscillation(wave.time, wave.value, floor_um).period, std::nullopt);
}

TEST(Oscillation, RestBelowTheFloorHasNoPeriod) {
  const Wave wave(1.0, 2000, [](double t) { return 0.001 * std::sin(tau * t / 0.2); });
  EXPECT_EQ(find_oscillation(wave.time, wave.value, floor_um).period, std::nullopt);
}

TEST(Oscillation, FewValuesSayNothing) {
  const std::vector<double> few = {0, 1, 0, 1};
  EXPECT_EQ(find_oscillation(few, few, floor_um).amplitude, std::nullopt);
}

}  // namespace
}  // namespace rouleau::campaign
