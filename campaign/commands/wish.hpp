// SPDX-License-Identifier: BSD-3-Clause
// How `cancel` and `retry` reach a campaign, whether or not somebody holds its lock.
#pragma once

#include <string>
#include <vector>

#include "commands/cli.hpp"
#include "commands/request.hpp"
#include "store/rows.hpp"

namespace rouleau::campaign {

/// The points that the words name, each once.   throws Error (usage) without words, (not_found) for a name of none
[[nodiscard]] std::vector<PointRow> named_points(const CommandLine& line, const char* verb);

/// Leaves the wish for these points and carries it out, or lets the process that holds the lock do so within a second.
void wish(const CommandLine& line, Wish wish, const std::vector<PointRow>& points);

}  // namespace rouleau::campaign
