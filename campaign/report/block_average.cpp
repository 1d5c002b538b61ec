// SPDX-License-Identifier: BSD-3-Clause
// The blocking transformation.
#include "report/block_average.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

double mean_of(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double standard_error_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double n = static_cast<double>(values.size());
  return std::sqrt(squares / (n * (n - 1)));
}

}  // namespace

BlockAverage block_average(std::span<const double> values) {
  require(!values.empty(), "the mean of an empty series was asked for");
  constexpr std::size_t fewest_blocks = 4;
  BlockAverage average;
  average.mean = mean_of(values);
  if (values.size() < fewest_blocks) return average;

  const double n = static_cast<double>(values.size());
  std::vector<double> blocks(values.begin(), values.end());
  const double first = standard_error_of(blocks);
  average.error = first;
  for (std::size_t block = 1; blocks.size() >= fewest_blocks; block *= 2) {
    const double error = standard_error_of(blocks);
    const double b = static_cast<double>(block);
    const double growth = first > 0 ? error / first : 1;
    if (b * b * b > 2 * n * growth * growth * growth * growth || first == 0) {
      average.error = error;
      average.block = block;
      average.converged = true;
      return average;
    }
    if (error >= *average.error) {
      average.error = error;
      average.block = block;
    }
    const std::size_t odd = blocks.size() % 2;  // the oldest block is dropped when it has no partner
    const std::size_t pairs = blocks.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i) blocks[i] = 0.5 * (blocks[odd + 2 * i] + blocks[odd + 2 * i + 1]);
    blocks.resize(pairs);
  }
  return average;
}

}  // namespace rouleau::campaign
