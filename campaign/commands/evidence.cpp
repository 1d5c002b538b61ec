// SPDX-License-Identifier: BSD-3-Clause
// Gathering evidence.
#include "commands/evidence.hpp"

#include <algorithm>

#include "executor/attempt.hpp"
#include "ingest/run_files.hpp"

namespace rouleau::campaign {

LifeOf life_by_files() {
  return {[](const ProcessIdentity& process) { return life_of(process); },
          [](const JobAttempt& attempt) {
            JobTrace trace;
            trace.answered = false;
            trace.exit_code = attempt.exit_code;
            trace.status = attempt.status;
            JobLife life = life_of_job(trace, 0);
            life.words.clear();
            return life;
          }};
}

namespace {

ExitRecord record_of(const ExitFile& exit) {
  return {exit.code, exit.reason, exit.start_step.value_or(0), exit.step.value_or(0)};
}

/// Whether nothing in the folder says yet who runs the attempt.
bool is_nameless(const std::filesystem::path& attempt) {
  const auto is_missing = [&](const char* name) {
    std::error_code unseen;
    return !std::filesystem::exists(attempt / name, unseen) && !unseen;
  };
  return is_missing("job") && is_missing("process.json") && is_missing("started.json") && is_missing("exit.json");
}

/// The records first, the scheduler second: it was asked before, and what it says is weighed against them.
void gather_job(Gathered& gathered, JobAttempt attempt, const LifeOf& life_of) {
  Evidence& evidence = gathered.evidence;
  const std::filesystem::path folder = attempt_directory(attempt.run_directory, attempt.number);
  const std::optional<ExitFile> exit = read_exit_file(folder / "exit.json", gathered.warnings);
  if (exit) attempt.exit_code = exit->code;
  attempt.status = read_status_file(folder / "status", gathered.warnings);
  attempt.start = read_start_file(folder / "start", gathered.warnings);
  const JobLife life = life_of.job(attempt);
  gathered.job = attempt.job;
  gathered.action = life.action;
  gathered.is_shown = life.is_shown;
  gathered.is_waiting = life.is_waiting;
  evidence.life = life.life;
  evidence.cause = life.cause;
  evidence.can_never_start = life.can_never_start;
  evidence.engine_words = life.words;
  if (exit) {
    evidence.exit = record_of(*exit);
  } else if (life.life == Life::dead) {
    evidence.last_words = last_line(folder / "stderr");
  }
}

/// A job that Slurm has started again makes its next attempt's folder first, and writes in it whose it is afterwards.
/// While the job of the attempt before lives, a folder that names nobody, and that the database does not know, is taken
/// for that: what there is to be told is still told of the attempt before. Returns whether it was.
bool gather_claiming_job(Gathered& gathered, const std::filesystem::path& run_directory,
                         const std::vector<int>& attempts, int recorded, const LifeOf& life_of) {
  if (attempts.size() < 2 || recorded >= attempts.back()) return false;
  if (!is_nameless(attempt_directory(run_directory, attempts.back()))) return false;
  const int before = attempts[attempts.size() - 2];
  std::vector<std::string> warnings;
  const std::optional<JobFile> job = read_job_file(attempt_directory(run_directory, before) / "job", warnings);
  if (!job) return false;
  Gathered of_job = gathered;
  of_job.evidence.newest_attempt = before;
  gather_job(of_job, {run_directory, before, *job, {}, {}, {}}, life_of);
  if (of_job.evidence.life != Life::alive) return false;
  gathered = std::move(of_job);
  return true;
}

}  // namespace

Gathered gather(const std::filesystem::path& run_directory, const AttemptRow* recorded, const LifeOf& life_of) {
  Gathered gathered;
  Evidence& evidence = gathered.evidence;
  const std::vector<std::int64_t> checkpoints = checkpoint_steps(run_directory);
  if (!checkpoints.empty()) evidence.newest_checkpoint = checkpoints.back();
  const std::vector<int> attempts = attempt_numbers(run_directory);
  evidence.newest_attempt = std::max(recorded ? recorded->number : 0, attempts.empty() ? 0 : attempts.back());
  if (evidence.newest_attempt == 0) return gathered;
  if (gather_claiming_job(gathered, run_directory, attempts, recorded ? recorded->number : 0, life_of)) return gathered;

  const std::filesystem::path attempt = attempt_directory(run_directory, evidence.newest_attempt);
  if (const std::optional<JobFile> job = read_job_file(attempt / "job", gathered.warnings)) {
    gather_job(gathered, {run_directory, evidence.newest_attempt, *job, {}, {}, {}}, life_of);
    return gathered;
  }
  std::optional<ProcessFile> file = read_process_file(attempt / "process.json", gathered.warnings);
  if (!file) file = read_process_file(attempt / "started.json", gathered.warnings);  // started by hand
  if (file) {
    gathered.process = {file->host, file->boot_id, file->pid, file->start_ticks};
    gathered.ranks = std::max(1, file->ranks);
    evidence.life = life_of.process(gathered.process);
  } else if (!gathered.warnings.empty() && recorded && recorded->number == evidence.newest_attempt) {
    // A file that cannot be read is no proof that nothing was started: the database knows what was. Of a job it does
    // not hold the name, without which an id proves nothing.
    gathered.process = {recorded->host, recorded->boot_id, recorded->pid, recorded->start_ticks};
    gathered.ranks = std::max(1, recorded->ranks);
    if (recorded->engine != local_engine)
      evidence.life = Life::unknown;
    else if (recorded->pid > 0)
      evidence.life = life_of.process(gathered.process);
  }
  // Life first, record second: a process that ends in between has then left its record already.
  if (const std::optional<ExitFile> exit = read_exit_file(attempt / "exit.json", gathered.warnings)) {
    evidence.exit = record_of(*exit);
  } else if (evidence.life == Life::dead) {
    evidence.last_words = last_line(attempt / "stderr");
  }
  return gathered;
}

Recorded recorded_of(const PointRow& point, const AttemptRow* newest) {
  Recorded recorded;
  recorded.state = point.state;
  recorded.retries_used = point.retries_used;
  recorded.end_step = point.end_step;
  if (newest != nullptr) {
    recorded.attempt = newest->number;
    recorded.attempt_is_open = newest->state != AttemptState::ended;
    recorded.checkpoint_at_start = newest->checkpoint_at_start;
  }
  return recorded;
}

}  // namespace rouleau::campaign
