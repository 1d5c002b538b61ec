// SPDX-License-Identifier: BSD-3-Clause
// The script of a Slurm job that runs one point or a pack of points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/cluster.hpp"

namespace rouleau::campaign {

/// One point of a job, with the attempt that was claimed for it.
struct ScriptPoint {
  std::string key;
  int attempt = 1;
  std::string token;  ///< in attempts/<attempt>/owner
};

struct JobScript {
  std::filesystem::path solver;     ///< the program, absolute
  std::filesystem::path campaign;   ///< its directory, absolute
  std::string name;                 ///< of the job
  int ranks = 1;                    ///< of each point
  std::vector<ScriptPoint> points;  ///< at least one; job.log is written in the attempt of the first
  std::vector<std::string> at_end;  ///< a command to run when all points have ended; empty = none
};

/// The text of job.sh. It stands by itself: it may be submitted by hand, from any directory, more than once.
///
/// For each point it makes attempts/<k>/begun, which only one can; if that is there already (Slurm has started the job
/// again, or somebody has submitted it twice) it claims an attempt of its own, so that two copies of a job never write
/// in one attempt's name (share/contract.md section 8). It starts nothing whose input files are not those that the sums
/// in points/<key>/inputs are of. It hands the solver the time that is left, passes SIGUSR2 and
/// SIGTERM on to it as SIGUSR2, and writes the solver's exit status to attempts/<k>/status.
///
/// Everything but the lines of `setup` is quoted, so that no path and no option can become shell code.
/// throws Error (usage) if a path holds a control character or a backslash, which no line for sbatch can carry
[[nodiscard]] std::string job_script(const Cluster& cluster, const JobScript& job);

/// A word that a shell reads as exactly this text.
[[nodiscard]] std::string shell_quoted(const std::string& text);

}  // namespace rouleau::campaign
