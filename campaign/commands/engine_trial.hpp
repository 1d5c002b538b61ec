// SPDX-License-Identifier: BSD-3-Clause
// A small real job that shows whether points could run on a cluster.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "executor/slurm.hpp"
#include "study/cluster.hpp"

namespace rouleau::campaign {

/// What the trial showed.
struct Trial {
  bool submitted = false;
  bool answers = true;  ///< false: Slurm fell silent; try later
  bool interrupted = false;
  std::string trouble;                  ///< why it did not come to its end, and what to do; "" = it did
  std::string node;                     ///< where it ran; "" = nothing of it was seen here
  double seen_after_s = 0;              ///< the release, until its first file was seen here
  std::optional<double> clock_ahead_s;  ///< the node's clock minus ours, at least so far apart; nothing: it never saw
                                        ///< what was written here
  int ranks = 0;                        ///< that the solver ran on, by its own record
  std::optional<int> code;              ///< the solver's exit code, by its own record
  std::string last_words;               ///< of the solver and its launcher
};

struct TrialOrder {
  std::filesystem::path solver;     ///< absolute
  std::filesystem::path directory;  ///< absolute, shared with the nodes: a folder is made in it, and removed
  double wait_s = 300;              ///< for the job's end
};

/// Submits a job of the cluster's partition, account, options and setup that runs rouleau-solver on two ranks for a
/// moment, and watches it to its end, the time-out or Ctrl-C; then nothing of it is left, in the queue or on the disk.
/// `say` is told of progress.
[[nodiscard]] Trial try_cluster(const Cluster& cluster, const TrialOrder& order,
                                const std::function<void(const std::string&)>& say);

/// The script of that job, for a folder made by the trial. The time limit and the size are the trial's own.
[[nodiscard]] std::string trial_script(const Cluster& cluster, const std::filesystem::path& solver,
                                       const std::filesystem::path& folder, const std::string& token);

}  // namespace rouleau::campaign
