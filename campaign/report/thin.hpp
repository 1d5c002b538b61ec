// SPDX-License-Identifier: BSD-3-Clause
// A long series with fewer points that looks the same.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rouleau::campaign {

/// Which values to keep so that at most `most` (at least 4) are left: first and last, and of each of equally long
/// stretches the smallest and the largest, so that no peak is lost.   returns indices, ascending; all if they are few
/// enough. A value that is not finite counts as neither.
[[nodiscard]] std::vector<std::size_t> thinned(std::span<const double> values, std::size_t most);

/// Which of ascending `positions` to take so that at most `most` (at least 1) of them lie as evenly as they can: the
/// last, the first, and those nearest to equal steps between.   returns indices, ascending, none twice
[[nodiscard]] std::vector<std::size_t> spread_evenly(std::span<const double> positions, std::size_t most);

}  // namespace rouleau::campaign
