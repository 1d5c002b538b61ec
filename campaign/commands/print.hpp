// SPDX-License-Identifier: BSD-3-Clause
// Listings to stdout in the format asked for.
#pragma once

#include "commands/cli.hpp"
#include "report/table.hpp"

namespace rouleau::campaign {

/// Writes the table as --format and --no-header say.
void print(const CommandLine& line, const Table& table);

}  // namespace rouleau::campaign
