// SPDX-License-Identifier: BSD-3-Clause
// A point's file as the cost arithmetic wants it.
#pragma once

#include <cstdint>
#include <filesystem>

#include "jobs/estimate.hpp"
#include "jobs/state.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

/// `steps_done`: behind its newest checkpoint. A point that is over has nothing left.
[[nodiscard]] PlannedPoint planned_point(const Point& point, State state, std::int64_t steps_done);

/// MiB that the point will write beyond what its directory holds already; none if it is over.
[[nodiscard]] double missing_MiB(const PlannedPoint& point, State state, const std::filesystem::path& run_directory);

}  // namespace rouleau::campaign
