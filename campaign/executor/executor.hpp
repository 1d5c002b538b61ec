// SPDX-License-Identifier: BSD-3-Clause
// What the campaign asks of an engine: start a job, say whether it lives, ask it to stop.
#pragma once

#include <filesystem>
#include <string>

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

class Executor {
 public:
  virtual ~Executor() = default;

  /// Starts the solver, detached from this process's life.   returns who it is
  /// throws Error (failed) if it could not be started; then no process is left
  virtual ProcessIdentity launch(const Order& order) = 0;

  /// Whether the process of an attempt lives. Never guesses: unknown is an answer.
  [[nodiscard]] virtual Life life(const ProcessIdentity& process) const = 0;

  /// Asks a job to write a checkpoint and end with 75. The caller has made the stop file already; this makes it quick.
  virtual void ask_to_stop(const ProcessIdentity& process, const std::filesystem::path& run_directory, int attempt) = 0;
};

}  // namespace rouleau::campaign
