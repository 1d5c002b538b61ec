// SPDX-License-Identifier: BSD-3-Clause
// The queue as tables, and the age of a run directory.
#include "commands/slurm_engine.hpp"

#include <algorithm>
#include <limits>

#include "executor/attempt.hpp"
#include "store/store.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

constexpr double longest_pause_s = 600;

/// Since anything that an attempt writes was written.
double silence_s(const std::filesystem::path& run_directory, int attempt) {
  std::filesystem::file_time_type newest{};
  bool found = false;
  const std::filesystem::path folder = attempt_directory(run_directory, attempt);
  for (const std::filesystem::path& file :
       {folder, folder / "stdout", folder / "stderr", run_directory / "progress.json", run_directory / "samples.csv",
        run_directory / "checkpoints"}) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(file, missing);
    if (missing) continue;
    newest = found ? std::max(newest, time) : time;
    found = true;
  }
  if (!found) return 0;  // nothing to be read is no silence
  return std::chrono::duration<double>(std::filesystem::file_time_type::clock::now() - newest).count();
}

}  // namespace

std::filesystem::path cluster_file(const std::filesystem::path& campaign) { return campaign / "cluster.ini"; }

bool SlurmEngine::look() {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_look_) return false;
  looked_unix_s_ = now_unix_s();
  jobs_ = slurm_.jobs();
  by_id_.clear();
  by_name_.clear();
  for (const JobRow& row : jobs_.rows) {
    by_id_[row.id] = &row;
    // Of several jobs of one name (a script submitted again by hand) the one that is not over counts.
    const JobRow*& named = by_name_[row.name];
    if (named == nullptr || view_of(named->state, named->reason, named->nodes).phase == Phase::ended) named = &row;
  }
  pause_s_ = jobs_.answered ? cluster_.poll_s : std::min(longest_pause_s, std::max(cluster_.poll_s, 2 * pause_s_));
  next_look_ = std::chrono::steady_clock::now() +
               std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(pause_s_));
  return true;
}

std::string SlurmEngine::id_of(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? "" : found->second->id;
}

std::vector<JobRow> SlurmEngine::held_jobs() const {
  std::vector<JobRow> held;
  for (const JobRow& row : jobs_.rows) {
    if (row.name.starts_with(job_name_prefix) && view_of(row.state, row.reason, row.nodes).phase == Phase::held)
      held.push_back(row);
  }
  return held;
}

JobLife SlurmEngine::life(const JobAttempt& attempt, const AttemptRow* row) const {
  JobTrace trace;
  trace.answered = jobs_.answered;
  trace.exit_code = attempt.exit_code;
  trace.status = attempt.status;
  // An attempt that the database does not know was claimed by a job script: it was submitted and released.
  trace.is_released = row == nullptr || row->state == AttemptState::launched;
  trace.since_intent_s = row == nullptr ? 0 : looked_unix_s_ - row->started_unix_s;
  // A submission that was refused has its end on record: nothing of it is under way.
  if (row != nullptr && row->state == AttemptState::ended) trace.since_intent_s = std::numeric_limits<double>::max();
  trace.job = attempt.job.id.empty() ? id_of(attempt.job.name) : attempt.job.id;
  trace.is_submitted = !trace.job.empty();
  const auto found = by_id_.find(trace.job);
  if (found != by_id_.end() && found->second->name == attempt.job.name) {
    trace.view = view_of(found->second->state, found->second->reason, found->second->nodes);
    // A controller that dies forgets its newest seconds: a job that has begun may stand as held again, as submitted.
    const bool has_begun = std::filesystem::exists(attempt_directory(attempt.run_directory, attempt.number) / "begun");
    if (has_begun && found->second->reason == "JobHeldUser") trace.is_released = false;
    // Of a job that runs, only the attempts of its present start can tell their end. Asked only when one has told it.
    const bool may_be_old = trace.view->phase == Phase::running && (trace.exit_code || trace.status);
    if (may_be_old) trace.has_started_anew = !attempt.start || slurm_.restarts(trace.job) != attempt.start;
  } else if (trace.answered && trace.is_submitted) {
    trace.silent_s = silence_s(attempt.run_directory, attempt.number);
  }
  return life_of_job(trace, cluster_.patience_min * 60);
}

}  // namespace rouleau::campaign
