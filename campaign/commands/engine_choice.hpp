// SPDX-License-Identifier: BSD-3-Clause
// The options of `run` that say where jobs are started.
#pragma once

#include "commands/cli.hpp"
#include "commands/manager.hpp"

namespace rouleau::campaign {

/// --engine, --cluster, --self-sustaining, --dry-run.
void describe_engine(boost::program_options::options_description& options);

/// Puts the cluster file into the campaign and sets the engine, for this and all later passes; without the options all
/// stays as it was.   throws Error (usage)
void choose_engine(const CommandLine& line, Manager& manager);

/// Prints the job scripts that would be submitted now.   returns the exit code
int print_scripts(const CommandLine& line, Manager& manager);

}  // namespace rouleau::campaign
