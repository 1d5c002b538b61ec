// SPDX-License-Identifier: BSD-3-Clause
// The flags that a simulation itself uses, against ray casting.
#pragma once

#include "follower.hpp"
#include "live_run.hpp"

namespace rouleau::validation {

testing::TrackingDifference own_difference(LiveRun& run);

}  // namespace rouleau::validation
