// SPDX-License-Identifier: BSD-3-Clause
// The picture of a campaign in a terminal: facts and a size in, lines out. Pure.
#pragma once

#include <string>
#include <vector>

#include "commands/watch_facts.hpp"
#include "commands/watch_table.hpp"

namespace rouleau::campaign {

/// At most look.rows lines of at most look.columns characters: totals, points, the last changes of state. If not all
/// points fit, those that run and those in trouble come first, and the others are counted in one line.
[[nodiscard]] std::vector<std::string> watch_lines(const WatchFacts& facts, const Look& look);

/// "12:00:01 #3 running -> crashed: attempt 2: its process is gone"; a change of another day begins with its date.
[[nodiscard]] std::string change_text(const Change& change, double now_unix_s);

/// "41 %, 3.10 core-h, ~5.20 left, ends ~ 3 Feb 14:20, in 2 h 10 min"
[[nodiscard]] std::string totals_text(const WatchFacts& facts);

/// "12:00:01", the local time of day
[[nodiscard]] std::string clock_text(double unix_s);

}  // namespace rouleau::campaign
