// SPDX-License-Identifier: BSD-3-Clause
// The engine "slurm": what Slurm said last, and how long until it is asked again.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "commands/evidence.hpp"
#include "executor/slurm.hpp"
#include "study/cluster.hpp"

namespace rouleau::campaign {

/// The name of a job is this and the token of its first point's attempt.
inline constexpr std::string_view job_name_prefix = "rouleau-";

/// Where a campaign keeps its cluster file.
[[nodiscard]] std::filesystem::path cluster_file(const std::filesystem::path& campaign);

/// One look at the queue serves all points; between looks the run directories speak.
class SlurmEngine {
 public:
  explicit SlurmEngine(Cluster cluster) : cluster_(std::move(cluster)), slurm_(cluster_.client_timeout_s) {}

  /// Asks for all jobs, unless it is too early: poll_s after an answer, twice as long after each silence.
  /// returns whether Slurm was asked
  bool look();

  /// Why Slurm did not answer last time; "" = it did, or was not asked yet.
  [[nodiscard]] const std::string& trouble() const { return jobs_.trouble; }

  /// Whether an attempt lives. `row`: what the database knows of it, null if nothing.
  [[nodiscard]] JobLife life(const JobAttempt& attempt, const AttemptRow* row) const;

  /// The id of the job of that name; "" = none is known.
  [[nodiscard]] std::string id_of(const std::string& name) const;

  /// The held jobs that a manager's submission may have left, by the name that script_of() gives them.
  [[nodiscard]] std::vector<JobRow> held_jobs() const;

  [[nodiscard]] const Cluster& cluster() const { return cluster_; }
  [[nodiscard]] const Slurm& client() const { return slurm_; }

 private:
  Cluster cluster_;
  Slurm slurm_;
  JobList jobs_;
  std::map<std::string, const JobRow*> by_id_, by_name_;
  std::chrono::steady_clock::time_point next_look_{};
  double looked_unix_s_ = 0;
  double pause_s_ = 0;
};

}  // namespace rouleau::campaign
