// SPDX-License-Identifier: BSD-3-Clause
// The rule of the class on series that show each of its cases.
#include "report/analysis.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;

constexpr double tau = 2 * std::numbers::pi;

/// A sample a millisecond (100 steps) from 0 to the end, d by the function of time.
std::vector<SampleRow> series(double end_s, const std::function<double(double)>& d_of, int cell = 0) {
  std::vector<SampleRow> samples;
  const auto n = static_cast<int>(std::lround(end_s * 1000));
  for (int i = 0; i <= n; ++i) {
    SampleRow sample;
    sample.step = 100 * i;
    sample.cell = cell;
    sample.time_s = 1e-5 * static_cast<double>(sample.step);
    const double d = d_of(sample.time_s);
    if (std::isfinite(d))
      sample.d_um = d;
    else
      sample.finite = false;
    sample.asphericity = 0.1;
    samples.push_back(sample);
  }
  return samples;
}

ResultRow result_of(const std::vector<SampleRow>& samples, const Analysis& analysis = {}) {
  return analyse("key", samples, analysis).at(0);
}

double slipper(double t) { return 0.9 + 0.2 * std::sin(tau * t / 0.2); }
double croissant(double t) { return 1.5 * std::exp(-t / 0.1); }

TEST(Analysis, CentredSeriesIsACroissant) {
  const ResultRow result = result_of(series(1.0, croissant));
  EXPECT_EQ(result.phase, "croissant") << result.phase_reason;
  EXPECT_LT(*result.d_mean_um, 0.01);
}

TEST(Analysis, OffCentreOscillationIsASlipperWithItsAmplitudeAndPeriod) {
  const ResultRow result = result_of(series(2.0, slipper));
  EXPECT_EQ(result.phase, "slipper") << result.phase_reason;
  EXPECT_NEAR(*result.d_mean_um, 0.9, 1e-3);  // the window is one period
  EXPECT_NEAR(*result.d_amplitude_um, 0.2, 0.01);
  EXPECT_NEAR(*result.d_period_s, 0.2, 0.005);
}

TEST(Analysis, WindowIsHalfOpenAndHoldsTheLastSample) {
  const ResultRow result = result_of(series(1.0, slipper));
  EXPECT_EQ(result.samples, 200);
  EXPECT_DOUBLE_EQ(result.window_start_s, 0.801);
  EXPECT_DOUBLE_EQ(result.time_s, 1.0);
  EXPECT_EQ(result.step, 100000);
}

TEST(Analysis, BetweenTheThresholdsIsUndecided) {
  const ResultRow result = result_of(series(1.0, [](double) { return 0.4; }));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_THAT(result.phase_reason, HasSubstr("between 0.3 and 0.5"));
}

TEST(Analysis, FallingSeriesIsNotASlipperYet) {
  const ResultRow result = result_of(series(1.0, [](double t) { return 2.0 - t; }));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_THAT(result.phase_reason, HasSubstr("fallen"));
}

TEST(Analysis, RisingSeriesIsNotACroissantAnyMore) {
  const ResultRow result = result_of(series(1.0, [](double t) { return t < 0.7 ? 0.0 : t - 0.7; }));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_THAT(result.phase_reason, HasSubstr("risen"));
}

TEST(Analysis, DriftAwayFromTheOtherClassDoesNoHarm) {
  EXPECT_EQ(result_of(series(1.0, [](double t) { return 0.6 + t; })).phase, "slipper");
  EXPECT_EQ(result_of(series(1.0, [](double t) { return std::max(0.0, 0.9 - t); })).phase, "croissant");
}

TEST(Analysis, SeriesShorterThanTwoWindowsIsUndecided) {
  const ResultRow result = result_of(series(0.3, slipper));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_THAT(result.phase_reason, HasSubstr("does not cover two windows"));
  EXPECT_TRUE(result.d_mean_um.has_value());
  EXPECT_EQ(result_of(series(0.4, slipper)).phase, "slipper");  // exactly two
}

TEST(Analysis, SeriesShorterThanTheWindowSaysSo) {
  EXPECT_THAT(result_of(series(0.1, slipper)).note, HasSubstr("0.1 s of the window of 0.2 s"));
}

TEST(Analysis, PhaseOfAWaveIsNotTakenForDrift) {
  Analysis analysis;
  analysis.window_s = 0.13;  // the means of such windows differ by up to 0.2 um
  for (int shift = 0; shift < 20; ++shift) {
    const auto shifted = [&](double t) { return slipper(t + 0.01 * shift); };
    EXPECT_EQ(result_of(series(2.0, shifted), analysis).phase, "slipper") << shift;
  }
}

TEST(Analysis, ThresholdsAreParameters) {
  Analysis analysis;
  analysis.croissant_d_um = 0.45;
  EXPECT_EQ(result_of(series(1.0, [](double) { return 0.4; }), analysis).phase, "croissant");
}

TEST(Analysis, AnotherWindowIsAnotherMean) {
  Analysis analysis;
  analysis.window_s = 0.05;
  const ResultRow result = result_of(series(1.0, slipper), analysis);
  EXPECT_EQ(result.samples, 50);
  EXPECT_NEAR(*result.d_mean_um, 0.9 - 0.2 * 2 / std::numbers::pi, 0.005);  // the last quarter of a period
}

TEST(Analysis, ValueThatIsNotFiniteMakesTheClassUndecidedAndTheMeanUnknown) {
  const ResultRow result =
      result_of(series(1.0, [](double t) { return std::abs(t - 0.9) < 1e-6 ? std::nan("") : 0.9; }));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_THAT(result.phase_reason, HasSubstr("not finite"));
  EXPECT_EQ(result.d_mean_um, std::nullopt);
  EXPECT_THAT(result.note, HasSubstr("not finite"));
}

TEST(Analysis, ValueThatWasNotFiniteLongAgoDoesNoHarm) {
  EXPECT_EQ(result_of(series(1.0, [](double t) { return t < 0.1 ? std::nan("") : 0.9; })).phase, "slipper");
}

TEST(Analysis, ChangedSamplingIntervalIsNoted) {
  std::vector<SampleRow> samples = series(1.0, slipper);
  samples.erase(samples.end() - 10);
  EXPECT_THAT(result_of(samples).note, HasSubstr("not equally spaced"));
  EXPECT_EQ(result_of(series(1.0, croissant)).note.find("equally"), std::string::npos);
}

TEST(Analysis, EachCellHasItsOwnResult) {
  std::vector<SampleRow> samples;
  const std::vector<SampleRow> first = series(1.0, croissant, 0), second = series(1.0, slipper, 1);
  for (std::size_t i = 0; i < first.size(); ++i) samples.insert(samples.end(), {first[i], second[i]});
  const std::vector<ResultRow> results = analyse("key", samples, {});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].phase, "croissant");
  EXPECT_EQ(results[1].phase, "slipper");
  EXPECT_EQ(results[1].cell, 1);
}

TEST(Analysis, NoSamplesNoResult) { EXPECT_TRUE(analyse("key", {}, {}).empty()); }

TEST(Analysis, SingleSampleIsUndecided) {
  const ResultRow result = result_of(series(0.0, slipper));
  EXPECT_EQ(result.phase, "undecided");
  EXPECT_EQ(result.d_error_um, std::nullopt);
}

}  // namespace
}  // namespace rouleau::campaign
