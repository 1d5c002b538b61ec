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
  options.add_options()                                                       //
      ("no-start", po::bool_switch(), "only look and record; start nothing")  //
      ("lock-patience-s", po::value<double>()->default_value(0)->value_name("S"),
       "wait so long for another `sync` to end; a `run` is not waited for");
}

int sync(const CommandLine& line) {
  ProgressLine progress(line.io, line.quiet);
  Manager manager(line.directory, "sync", [&](const std::string& message) { progress.say(message); },
                  {line.get<double>("lock-patience-s")});
  manager.take_requests();
  manager.reconcile(true);
  manager.ingest_living();
  if (!line.is_set("no-start")) manager.start();
  progress.say(counts_text(manager.counts()));
  if (!manager.engine_trouble().empty()) return static_cast<int>(Exit::engine_unreachable);
  return static_cast<int>(outcome_of(manager));
}

}  // namespace

const Verb sync_verb = {
    "sync",
    "one pass: record what became of the jobs, start what can be started",
    "[DIR] [--no-start] [--lock-patience-s S]",
    "  rouleau sync my-campaign                  one pass of what `run` does\n"
    "  */5 * * * * rouleau sync -q my-campaign   a campaign driven by cron\n",
    "Starts jobs where the campaign's engine is: the study's, or that of the last `rouleau run --engine`.\n"
    "Ends with 0, with 4 when some points failed, with 6 when Slurm did not answer (nothing is concluded from that).\n",
    Words::campaign,
    false,
    describe,
    sync,
};

}  // namespace rouleau::campaign
