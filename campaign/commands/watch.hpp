// SPDX-License-Identifier: BSD-3-Clause
// Looking at a campaign until it is through or the user has seen enough: a screen in a terminal, lines elsewhere.
#pragma once

#include <optional>
#include <vector>

#include "commands/cli.hpp"
#include "commands/point_status.hpp"

namespace rouleau::campaign {

/// Draws or writes every `interval_s` seconds; without one every 2 s in a terminal and every minute elsewhere. Ctrl-C,
/// SIGTERM and SIGHUP end it; the last picture stays in the terminal.   returns the points as they were last seen
std::vector<PointStatus> watch(const CommandLine& line, std::optional<double> interval_s);

}  // namespace rouleau::campaign
