// SPDX-License-Identifier: BSD-3-Clause
// The engine "local": jobs are processes of this machine that outlive their manager.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "executor/cores.hpp"
#include "executor/process.hpp"

namespace rouleau::campaign {

/// One start of the solver. attempts/<attempt>/ with its owner exists already.
struct Order {
  std::filesystem::path solver;         ///< the program, absolute
  std::filesystem::path run_directory;  ///< absolute
  int attempt = 1;
  std::string token;
  int ranks = 1;
  std::int64_t checkpoint_step = -1;  ///< newest checkpoint now; -1 = none
  Cores cores;                        ///< to be pinned to; empty = not pinned
  int niceness = 0;
};

/// Starts each job in a session of its own (a terminal's Ctrl-C does not reach it), with stdin from /dev/null, stdout
/// and stderr to files of the attempt, pinned to its cores. One rank is started directly, more through mpirun: a start
/// takes 0.3 s instead of 2.3 s, and signals need no forwarding.
class LocalExecutor {
 public:
  /// Starts the solver, detached from this process's life.   returns who it is
  /// throws Error (failed) if it could not be started; then no process is left
  ProcessIdentity launch(const Order& order);

  /// Whether the process of an attempt lives. Never guesses: unknown is an answer.
  [[nodiscard]] Life life(const ProcessIdentity& process) const { return life_of(process); }

  /// Asks a job to write a checkpoint and end with 75. The caller has made the stop file already; this makes it quick.
  void ask_to_stop(const ProcessIdentity& process, const std::filesystem::path& run_directory, int attempt);

  /// Takes note of children that ended, so that no zombies stay.
  void reap();
};

/// What stands in front of the solver's command: nothing for one rank, else mpirun. `cores` = how many the job has.
[[nodiscard]] std::vector<std::string> mpi_prefix(int ranks, int cores);

/// The command of a job.
[[nodiscard]] std::vector<std::string> job_command(const Order& order);

}  // namespace rouleau::campaign
