// SPDX-License-Identifier: BSD-3-Clause
// A cluster file: what to ask of Slurm and how a job is set up there. It holds no physics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// The settings of cluster.ini. An empty text means that nothing is said to Slurm, so that its default holds.
struct Cluster {
  std::string partition;
  std::string account;
  std::string qos;
  double time_limit_s = 0;  ///< of a job; must be given. Slurm counts whole minutes
  double points_per_job = 1;
  double nodes = 1;
  double ranks = 0;  ///< MPI ranks of a point; 0 = as [execution] of the study says
  double memory_per_rank_MiB = 0;
  std::string launcher = "srun";  ///< srun or mpirun
  std::string mpi = "pmix";       ///< of srun --mpi; "" = the option is not given
  double jobs = 50;               ///< queued and running at a time
  double submissions_per_pass = 20;
  double poll_s = 30;               ///< between two passes of `rouleau run`
  double patience_min = 15;         ///< a job that Slurm does not know and that shows no progress for so long is lost
  double client_timeout_s = 30;     ///< of one call of sbatch, squeue, scontrol, scancel
  double signal_s = 120;            ///< SIGUSR2 so long before the time limit; 0 = none
  double requeue = 1;               ///< 1: Slurm may start a job again after a node failure or a preemption
  std::vector<std::string> sbatch;  ///< further options of sbatch, each a line of its own, in order
  std::vector<std::string> setup;   ///< lines of shell code for the job script, in order
};

/// Reads a cluster file from its text: `name = value` lines, `#` comments, at most the section [cluster]. `sbatch` and
/// `setup` may be given several times; the value of `setup` is taken as it stands, with any `#`. `mpi = default` means
/// that no --mpi is given. Errors begin "cluster.ini:LINE:", with the name of `source`.
/// throws Error (usage) at the first thing that is wrong
[[nodiscard]] Cluster parse_cluster(const std::string& text, const std::filesystem::path& source);

/// The same from a file.   throws Error (not_found) if there is none
[[nodiscard]] Cluster read_cluster(const std::filesystem::path& file);

/// A time limit as sbatch takes it, in s: minutes, M:S, H:M:S, D-H, D-H:M or D-H:M:S; negative if it is none of these.
[[nodiscard]] double seconds_of_time_limit(const std::string& text);

/// How a cluster file is written, for people: every key with default, range and meaning.
[[nodiscard]] std::string cluster_help();

}  // namespace rouleau::campaign
