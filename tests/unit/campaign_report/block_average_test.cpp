// SPDX-License-Identifier: BSD-3-Clause
// The error of the mean against series whose true error is known.
#include "report/block_average.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace rouleau::campaign {
namespace {

/// x' = phi x + noise of unit variance: the correlation falls as phi^n.
std::vector<double> autoregressive(std::size_t n, double phi, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise;
  std::vector<double> series(n);
  double x = noise(random) / std::sqrt(1 - phi * phi);
  for (double& value : series) value = x = phi * x + noise(random);
  return series;
}

/// Of the mean of n values, for n much longer than the correlation: sigma / ((1 - phi) sqrt(n)).
double true_error(std::size_t n, double phi) { return 1 / ((1 - phi) * std::sqrt(static_cast<double>(n))); }

double mean_ratio_of_errors(double phi, std::size_t n) {
  constexpr unsigned runs = 200;
  double squares = 0;
  for (unsigned seed = 0; seed < runs; ++seed) {
    const double error = *block_average(autoregressive(n, phi, seed)).error;
    squares += error * error;
  }
  return std::sqrt(squares / runs) / true_error(n, phi);
}

TEST(BlockAverage, ErrorOfIndependentValuesIsTheStandardError) {
  // The block chosen is about (2 n)^(1/3) = 20 long, 205 blocks: 5 % a run, 0.4 % over 200 runs; the choice biases by
  // less.
  EXPECT_NEAR(mean_ratio_of_errors(0.0, 4096), 1, 0.05);
}

TEST(BlockAverage, ErrorOfCorrelatedValuesIsTheTrueOne) {
  // The naive error would be sqrt((1 - phi) / (1 + phi)) = 0.23 and 0.1 of the true one. Too short blocks bias
  // downwards by as much as too few scatter: 10 % of n = 16384 at a correlation of 20, 15 % at 100.
  EXPECT_NEAR(mean_ratio_of_errors(0.9, 16384), 1, 0.10);
  EXPECT_NEAR(mean_ratio_of_errors(0.98, 16384), 1, 0.15);
}

TEST(BlockAverage, MeanIsOfAllValues) {
  const std::vector<double> values = {1, 2, 3, 4, 10};
  EXPECT_DOUBLE_EQ(block_average(values).mean, 4);
}

TEST(BlockAverage, ConstantSeriesHasNoError) {
  const std::vector<double> values(100, 0.25);
  const BlockAverage average = block_average(values);
  EXPECT_EQ(average.mean, 0.25);
  EXPECT_EQ(average.error, 0.0);
  EXPECT_TRUE(average.converged);
}

TEST(BlockAverage, FewValuesHaveNoError) {
  const std::vector<double> values = {1, 2, 3};
  EXPECT_EQ(block_average(values).error, std::nullopt);
}

TEST(BlockAverage, CorrelationLongerThanTheSeriesIsSaid) {
  std::vector<double> ramp(256);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<double>(i);
  EXPECT_FALSE(block_average(ramp).converged);
}

}  // namespace
}  // namespace rouleau::campaign
