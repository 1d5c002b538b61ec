// SPDX-License-Identifier: BSD-3-Clause
// The mean of a correlated series and its standard error from block averages.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace rouleau::campaign {

struct BlockAverage {
  double mean = 0;
  std::optional<double> error;  ///< standard error of the mean; unset below four values
  std::size_t block = 1;        ///< values in a block
  bool converged = false;       ///< false: longer blocks would be needed, the error is a lower bound
};

/// Repeated averaging of neighbours: blocks of b = 1, 2, 4 ... values while at least four blocks remain (an odd
/// oldest block is left out of the error, never of the mean). The standard error grows with b until blocks are longer
/// than the correlation. Taken is the smallest b with  b^3 > 2 n (s_b / s_1)^4,  where the systematic error of too
/// short blocks equals the statistical one of too few.   [Flyvbjerg, Petersen 1989; Lee, Needs et al. 2011, Phys. Rev.
/// E 83, 066706] If no b is long enough, the largest s_b is given and `converged` is false. values  equally spaced,
/// oldest first, finite, at least one. Sums run in the given order: the same bits every time.
BlockAverage block_average(std::span<const double> values);

}  // namespace rouleau::campaign
