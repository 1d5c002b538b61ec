// SPDX-License-Identifier: BSD-3-Clause
// The engine "local": jobs are processes of this machine that outlive their manager.
#pragma once

#include <filesystem>

#include "executor/executor.hpp"

namespace rouleau::campaign {

/// Starts each job in a session of its own (a terminal's Ctrl-C does not reach it), with stdin from /dev/null, stdout
/// and stderr to files of the attempt, pinned to its cores. One rank is started directly, more through mpirun: a start
/// takes 0.3 s instead of 2.3 s, and signals need no forwarding.
class LocalExecutor : public Executor {
 public:
  ProcessIdentity launch(const Order& order) override;
  [[nodiscard]] Life life(const ProcessIdentity& process) const override { return life_of(process); }
  void ask_to_stop(const ProcessIdentity& process, const std::filesystem::path& run_directory, int attempt) override;

  /// Takes note of children that ended, so that no zombies stay.
  void reap();
};

/// What stands in front of the solver's command: nothing for one rank, else mpirun. `cores` = how many the job has.
[[nodiscard]] std::vector<std::string> mpi_prefix(int ranks, int cores);

/// The command of a job.
[[nodiscard]] std::vector<std::string> job_command(const Order& order);

}  // namespace rouleau::campaign
