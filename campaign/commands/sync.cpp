// SPDX-License-Identifier: BSD-3-Clause
// `rouleau sync`: one pass without waiting, for cron and for the curious.
#include <ostream>

#include "commands/outcome.hpp"
#include "commands/progress_line.hpp"
#include "commands/verbs.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

void describe(po::options_description& options) {
  options.add_options()("no-start", po::bool_switch(), "only look and record; start nothing");
}

int sync(const CommandLine& line) {
  ProgressLine progress(line.io, line.quiet);
  Manager manager(line.directory, "sync", [&](const std::string& message) { progress.say(message); });
  manager.take_requests();
  manager.reconcile(true);
  manager.ingest_living();
  if (!line.is_set("no-start")) manager.start();
  progress.say(counts_text(manager.counts()));
  return static_cast<int>(outcome_of(manager));
}

}  // namespace

const Verb sync_verb = {
    "sync",
    "one pass: record what became of the jobs, start what can be started",
    "[DIR] [--no-start]",
    "  rouleau sync my-campaign                  one pass of what `run` does\n"
    "  */5 * * * * rouleau sync -q my-campaign   a campaign driven by cron\n",
    "Ends with 0, or with 4 when some points failed.\n",
    Words::campaign,
    false,
    describe,
    sync,
};

}  // namespace rouleau::campaign
