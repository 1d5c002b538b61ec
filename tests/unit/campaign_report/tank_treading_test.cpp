// SPDX-License-Identifier: BSD-3-Clause
// The tank-treading frequency of motions whose frequency is known.
#include "report/tank_treading.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "report/analysis.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;

constexpr double two_pi = 2 * std::numbers::pi;

/// Angles in turns, as functions of the time.
using Angle = std::function<double(double)>;

/// A sample a millisecond. The marker of z goes around in the x-z plane at the angle `marker`, the axis lies at `axis`;
/// the marker of y rests on the y axis.
std::vector<SampleRow> motion(double end_s, const Angle& marker, const Angle& axis) {
  std::vector<SampleRow> samples;
  const auto n = static_cast<int>(std::lround(end_s * 1000));
  for (int i = 0; i <= n; ++i) {
    SampleRow sample;
    sample.step = 100 * i;
    sample.time_s = 1e-3 * i;
    const double phi = two_pi * marker(sample.time_s), radius = 2 + std::cos(2 * phi);
    sample.marker_z_dx_um = radius * std::cos(phi);
    sample.marker_z_dy_um = 0;
    sample.marker_z_dz_um = radius * std::sin(phi);
    sample.marker_y_dx_um = sample.marker_y_dz_um = 0.01;
    sample.marker_y_dy_um = 2;
    const double half_turns = 2 * axis(sample.time_s);
    sample.angle_xz_deg = 180 * (half_turns - std::ceil(half_turns - 0.5));  // an axis has no sign
    sample.angle_xy_deg = 0;
    samples.push_back(sample);
  }
  return samples;
}

Angle steady(double per_s) {
  return [=](double t) { return 0.3 + per_s * t; };
}

TEST(TankTreading, SteadyMembraneHasItsFrequencyWhicheverWayItGoes) {
  for (const double f : {7.0, -7.0}) {
    const TankTreading found = tank_treading(motion(1.05, steady(f), steady(0)), -1);
    ASSERT_TRUE(found.per_s) << found.reason;
    EXPECT_NEAR(*found.per_s, 7, 1e-9);
    EXPECT_NEAR(*found.error_per_s, 0, 1e-5);
    EXPECT_THAT(found.reason, HasSubstr("7 turns in the x-z plane"));
  }
}

TEST(TankTreading, RigidTumblingIsNone) {
  const TankTreading found = tank_treading(motion(2, steady(3), steady(3)), -1);
  EXPECT_FALSE(found.per_s);
  EXPECT_THAT(found.reason, HasSubstr("less than one turn"));
}

TEST(TankTreading, TumblingIsTakenOff) {
  const TankTreading found = tank_treading(motion(2, steady(5), steady(2)), -1);
  ASSERT_TRUE(found.per_s) << found.reason;
  EXPECT_NEAR(*found.per_s, 3, 1e-9);
}

TEST(TankTreading, UnevenTurnsAreCountedWhole) {
  // Within a turn the membrane goes fast and slow; the window ends in the middle of one.
  const Angle uneven = [](double t) { return 4 * t + 0.1 * std::sin(two_pi * 4 * t); };
  const TankTreading found = tank_treading(motion(0.9, uneven, steady(0)), -1);
  ASSERT_TRUE(found.per_s) << found.reason;
  EXPECT_NEAR(*found.per_s, 4, 4e-3);  // the crossing is interpolated between samples 1/250 of a turn apart
}

TEST(TankTreading, ErrorIsThatOfTheSingleTurns) {
  // Turns of 0.1 s and 0.2 s in turn: rates 10 and 5 about their mean over time of 20/3, ten of them.
  const Angle alternating = [](double t) {
    const double pairs = std::floor(t / 0.3), rest = t - 0.3 * pairs;
    return 2 * pairs + (rest < 0.1 ? rest / 0.1 : 1 + (rest - 0.1) / 0.2);
  };
  const TankTreading found = tank_treading(motion(1.5, alternating, steady(0)), -1);
  ASSERT_TRUE(found.per_s) << found.reason;
  EXPECT_NEAR(*found.per_s, 20.0 / 3, 1e-6);
  const double variance = (std::pow(10 - 20.0 / 3, 2) + std::pow(5 - 20.0 / 3, 2)) / 2 + 2 * (7.5 - 20.0 / 3) * 20 / 3;
  EXPECT_NEAR(*found.error_per_s, std::sqrt(variance / 9), 0.02);
}

TEST(TankTreading, OnlyTheWindowCounts) {
  const Angle changing = [](double t) { return t < 1 ? 2 * t : 2 + 6 * (t - 1); };
  const TankTreading found = tank_treading(motion(2, changing, steady(0)), 1);
  ASSERT_TRUE(found.per_s) << found.reason;
  EXPECT_NEAR(*found.per_s, 6, 1e-6);
}

TEST(TankTreading, IsSeenInTheOtherPlaneToo) {
  std::vector<SampleRow> samples = motion(1, steady(5), steady(0));
  for (SampleRow& s : samples) {
    std::swap(s.marker_z_dx_um, s.marker_y_dx_um);
    std::swap(s.marker_z_dz_um, s.marker_y_dy_um);
    std::swap(s.angle_xz_deg, s.angle_xy_deg);
  }
  const TankTreading found = tank_treading(samples, -1);
  ASSERT_TRUE(found.per_s) << found.reason;
  EXPECT_NEAR(*found.per_s, 5, 1e-9);
  EXPECT_THAT(found.reason, HasSubstr("x-y plane"));
}

TEST(TankTreading, PlaneInWhichTheCellIsRoundIsPassedBy) {
  std::vector<SampleRow> samples = motion(1, steady(5), steady(0));
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].angle_xy_deg = i % 2 == 0 ? 80 : -10;
  EXPECT_TRUE(tank_treading(samples, -1).per_s);
  for (SampleRow& s : samples) s.marker_z_dx_um = s.marker_z_dz_um = 1;
  EXPECT_THAT(tank_treading(samples, -1).reason, HasSubstr("too far apart"));
}

TEST(TankTreading, CoarseSamplesAreNotGuessedAt) {
  const TankTreading found = tank_treading(motion(1, steady(400), steady(0)), -1);
  EXPECT_FALSE(found.per_s);
}

TEST(TankTreading, LogOfAnOlderSolverHasNoneAndSaysSo) {
  std::vector<SampleRow> samples(20);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].step = static_cast<std::int64_t>(i);
    samples[i].time_s = 0.01 * static_cast<double>(i);
    samples[i].d_um = samples[i].asphericity = 0.1;
  }
  const ResultRow result = analyse("key", samples, {}).at(0);
  EXPECT_EQ(result.tank_treading_per_s, std::nullopt);
  EXPECT_THAT(result.tank_treading_reason, HasSubstr("older solver"));
}

TEST(TankTreading, IsPartOfTheResult) {
  std::vector<SampleRow> samples = motion(3, steady(2.5), steady(0));
  for (SampleRow& s : samples) s.d_um = s.asphericity = 0.1;
  const ResultRow result = analyse("key", samples, {}).at(0);
  ASSERT_TRUE(result.tank_treading_per_s) << result.tank_treading_reason;
  EXPECT_NEAR(*result.tank_treading_per_s, 2.5, 1e-9);
  EXPECT_THAT(result.tank_treading_reason, HasSubstr("2 turns in the x-z plane"));  // of oscillation_window_s = 1
}

}  // namespace
}  // namespace rouleau::campaign
