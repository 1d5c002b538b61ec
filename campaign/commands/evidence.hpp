// SPDX-License-Identifier: BSD-3-Clause
// What a run directory proves about its newest attempt, gathered for the judge.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "executor/process.hpp"
#include "ingest/run_files.hpp"
#include "jobs/job_life.hpp"
#include "store/rows.hpp"

namespace rouleau::campaign {

/// The newest attempt, if it was handed to Slurm, as its files tell it.
struct JobAttempt {
  std::filesystem::path run_directory;
  int number = 0;
  JobFile job;
  std::optional<int> exit_code, status;
  std::optional<int> start;  ///< which start of its job it belongs to: 0, 1, ...
};

/// The judge's evidence and the process or the job it is about.
struct Gathered {
  Evidence evidence;
  ProcessIdentity process;             ///< pid 0: none known
  std::optional<JobFile> job;          ///< set: the attempt runs under Slurm
  JobAction action = JobAction::none;  ///< what is to be done about the job
  bool is_shown = false;               ///< the scheduler showed it, past our hold
  bool is_waiting = false;             ///< and it waits for its start
  int ranks = 1;
  std::vector<std::string> warnings;  ///< damaged files
};

/// Says whether a process lives, and whether a job does.
struct LifeOf {
  std::function<Life(const ProcessIdentity&)> process;
  std::function<JobLife(const JobAttempt&)> job;
};

/// For readers, who do not ask Slurm: its jobs count as alive until their own records end them.
[[nodiscard]] LifeOf life_by_files();

/// Reads a run directory. `recorded` is the newest attempt that the database knows (nullptr = none): if its folder is
/// not there yet, the evidence is about it all the same, and empty; if the file that names its process cannot be read,
/// the database's word is taken for it (a job of a scheduler then counts as out of sight).
[[nodiscard]] Gathered gather(const std::filesystem::path& run_directory, const AttemptRow* recorded,
                              const LifeOf& life_of);

/// What the database knows, as the judge wants it.
[[nodiscard]] Recorded recorded_of(const PointRow& point, const AttemptRow* newest);

}  // namespace rouleau::campaign
