// SPDX-License-Identifier: BSD-3-Clause
// Starting: intent recorded, attempt claimed, process started, outcome recorded.
#include <algorithm>

#include "commands/manager.hpp"
#include "commands/pause.hpp"
#include "commands/planned_point.hpp"
#include "executor/attempt.hpp"
#include "executor/solver.hpp"
#include "ingest/ingest.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/input_files.hpp"

namespace rouleau::campaign {

namespace {

/// A start needs room for the checkpoint being written aside, one more, and something for logs.
constexpr std::int64_t checkpoints_of_room = 2;
constexpr std::int64_t bytes_for_logs = 1 << 20;

/// What a run may write beyond what it has: at least the checkpoint being written aside.
std::int64_t room_of(const Point& point, std::size_t generations) {
  const std::int64_t missing = checkpoints_of_room - static_cast<std::int64_t>(generations);
  return std::max<std::int64_t>(1, missing) * point.facts.checkpoint_bytes + bytes_for_logs;
}

}  // namespace

std::vector<Startable> Manager::startables() const {
  std::vector<Startable> all;
  for (const PointRow& point : store_.points()) {
    all.push_back({point.key, point.ordinal, point.state, point.in_study, living_job(point.key) != nullptr,
                   point.retry_at_unix_s});
  }
  return all;
}

Cores Manager::free_cores_now() const {
  std::vector<Occupant> occupants;
  for (const LivingJob& job : living_) {
    if (job.is_seen && !job.job) occupants.push_back({cores_of(static_cast<pid_t>(job.process.pid)), job.ranks});
  }
  return quiet_first(free_cores(allowed_, occupants), cores_of_solvers());
}

Capacity Manager::capacity(const Cores& free) const {
  const Execution& execution = study_.execution;
  const int ranks = static_cast<int>(execution.ranks);
  const int cores = static_cast<int>(allowed_.size());
  const int jobs = static_cast<int>(execution.jobs);
  const auto jobs_of_slurm =
      static_cast<int>(std::count_if(living_.begin(), living_.end(), [](const LivingJob& job) { return job.job; }));
  return {jobs_of_slurm + (jobs > 0 ? jobs : std::max(1, cores / ranks)), static_cast<int>(free.size()), ranks,
          execution.oversubscribe != 0};
}

int Manager::start() {
  promised_bytes_.reset();
  const int started = is_paused() ? 0 : engine_.name == slurm_engine ? submit() : start_here();
  if (is_paused()) warn_of({pause_text(breaker_)});  // also of failed starts just now
  return started;
}

int Manager::start_here() {
  Cores free = free_cores_now();
  const Capacity capacity = this->capacity(free);
  const int cores = static_cast<int>(allowed_.size());
  if (!capacity.oversubscribe && capacity.ranks > cores) {
    fail(Exit::usage,
         "study.ini: [execution] ranks = {}, but this machine gives rouleau {} cores. Lower ranks, or set "
         "oversubscribe = 1.",
         capacity.ranks, cores);
  }
  const auto jobs = static_cast<int>(study_.execution.jobs);
  if (!capacity.oversubscribe && jobs * capacity.ranks > cores) {
    warn_of(
        {fmt::format("jobs = {} of {} ranks do not fit on {} cores: {} run at a time (oversubscribe = 1 allows more)",
                     jobs, capacity.ranks, cores, cores / capacity.ranks)});
  }
  const std::vector<std::string> keys = choose_starts(startables(), capacity, now_unix_s());
  if (!keys.empty() && solver_.empty()) solver_ = find_solver();
  int started = 0;
  for (const std::string& key : keys) {
    const PointRow point = store_.point(key).value();
    // More ranks than free cores (oversubscribed): the system places them.
    const auto taken = static_cast<std::ptrdiff_t>(capacity.ranks);
    Cores own;
    if (static_cast<std::ptrdiff_t>(free.size()) >= taken) {
      own.assign(free.begin(), free.begin() + taken);
      free.erase(free.begin(), free.begin() + taken);
    }
    if (start_point(point, own)) ++started;
    if (is_paused()) break;
  }
  return started;
}

void Manager::check_room() {
  double need_MiB = 0;
  for (const PointRow& point : store_.points()) {
    if (!point.in_study || is_final(point.state)) continue;
    const std::filesystem::path run = run_directory(point.key);
    try {
      need_MiB += missing_MiB(planned_point(read_point(run / "point.json"), point.state, 0), point.state, run);
    } catch (const Error& error) {
      warn_of({name_of(point) + ": " + error.what()});
    }
  }
  const double free_MiB = static_cast<double>(std::filesystem::space(directory_).available) / (1 << 20);
  if (free_MiB >= need_MiB) return;
  warn_of(
      {fmt::format("{}: the disk has {:.0f} MiB free, the points left will need {:.0f} MiB. Make room meanwhile; "
                   "nothing is lost when it is full, points wait then.",
                   directory_.string(), free_MiB, need_MiB)});
}

std::int64_t Manager::room_of_living() const {
  std::int64_t bytes = 0;
  for (const LivingJob& job : living_) {
    const std::filesystem::path run = run_directory(job.key);
    try {
      bytes += room_of(read_point(run / "point.json"), checkpoint_steps(run).size());
    } catch (const Error&) {
      // Damaged while its job runs: named when it is started next.
    }
  }
  return bytes;
}

/// The disk is asked before any of the starts of a pass has written anything, so they are counted here.
bool Manager::take_room_for(const PointRow& point) {
  const std::int64_t need = room_of(read_point(run_directory(point.key) / "point.json"), 0);
  if (!promised_bytes_) promised_bytes_ = room_of_living();
  std::error_code error;
  const auto free = static_cast<std::int64_t>(std::filesystem::space(directory_, error).available);
  if (error) fail(Exit::failed, "{}: cannot ask for its free space: {}.", directory_.string(), error.message());
  if (free - *promised_bytes_ >= need) {
    *promised_bytes_ += need;
    waits_for_room_ = false;
    return true;
  }
  if (!waits_for_room_)
    say_(
        fmt::format("warning: {}: the disk has {} MiB free, {} MiB of them for jobs that run; a start needs {} MiB. "
                    "Points wait until there is room.",
                    directory_.string(), free >> 20, *promised_bytes_ >> 20, need >> 20));
  waits_for_room_ = true;
  return false;
}

AttemptRow Manager::planned_attempt(const PointRow& point, const Cores& cores) const {
  const std::optional<AttemptRow> newest = store_.newest_attempt(point.key);
  AttemptRow attempt;
  attempt.point = point.key;
  attempt.number = 1 + (newest ? newest->number : 0);
  attempt.token = new_token();
  attempt.state = AttemptState::planned;
  attempt.host = host_name();
  attempt.ranks = static_cast<int>(study_.execution.ranks);
  attempt.cores = to_text(cores);
  attempt.started_unix_s = now_unix_s();
  return attempt;
}

void Manager::fit_to_directory(AttemptRow& attempt) const {
  const std::filesystem::path run = run_directory(attempt.point);
  const std::vector<int> attempts = attempt_numbers(run);
  const std::vector<std::int64_t> checkpoints = checkpoint_steps(run);
  if (!attempts.empty()) attempt.number = std::max(attempt.number, attempts.back() + 1);
  if (!checkpoints.empty()) attempt.checkpoint_at_start = checkpoints.back();
}

bool Manager::start_point(const PointRow& point, const Cores& cores) {
  AttemptRow attempt = planned_attempt(point, cores);
  const std::filesystem::path run = run_directory(point.key);
  ProcessIdentity process;
  std::string how;
  bool is_claimed = false;
  try {
    fit_to_directory(attempt);
    if (!take_room_for(point)) return false;
    require_input_files(run, read_point(run / "point.json"));
    Transaction intent = store_.begin();
    store_.put_attempt(attempt);
    how = attempt.checkpoint_at_start < 0
              ? "from the start"
              : fmt::format("again, newest checkpoint on disk {}", attempt.checkpoint_at_start);
    const std::string evidence = fmt::format("attempt {} is started {}", attempt.number, how);
    if (!store_.change_state(point.key, point.state, State::running, evidence, attempt.number)) return false;
    intent.commit();

    remove_stop_file(run);
    claim_attempt(run, attempt.number, attempt.token);
    is_claimed = true;
    process = executor_.launch({solver_, run, attempt.number, attempt.token, attempt.ranks, attempt.checkpoint_at_start,
                                cores, static_cast<int>(study_.execution.niceness)});
  } catch (const DatabaseError&) {
    throw;  // the intent was not recorded, and nothing is started without
  } catch (const Error& error) {
    record_failed_launch(point, attempt, is_claimed ? LaunchTrouble::engine : trouble_of(error), error.what());
    return false;
  }
  // A process is running from here on: what fails now is no failed launch, and the next pass finds it by its
  // process.json.
  attempt.host = process.host;
  attempt.boot_id = process.boot_id;
  attempt.pid = process.pid;
  attempt.start_ticks = process.start_ticks;
  attempt.state = AttemptState::launched;
  living_.push_back({point.key, point.ordinal, attempt.number, attempt.ranks, true, process, {}, ""});
  store_.put_attempt(attempt);
  const char* where = cores.empty() ? "" : cores.size() > 1 ? ", on cores " : ", on core ";
  say_(fmt::format("{}: attempt {} started {}{}{}", name_of(point), attempt.number, how, where, to_text(cores)));
  return true;
}

LaunchTrouble Manager::trouble_of(const Error& error) {
  return error.code() == Exit::damaged ? LaunchTrouble::damage : LaunchTrouble::files;
}

void Manager::record_failed_launch(const PointRow& point, AttemptRow attempt, LaunchTrouble trouble,
                                   const std::string& why) {
  const PointRow now = store_.point(point.key).value();
  Recorded recorded = recorded_of(now, &attempt);
  Transaction outcome = store_.begin();
  attempt.state = AttemptState::ended;
  attempt.ended_unix_s = now_unix_s();
  attempt.reason = why;
  store_.put_attempt(attempt);
  recorded.starts_in_vain = starts_in_vain(store_.attempts(point.key));
  const Verdict verdict = judge_failed_launch(recorded, trouble, why, policy_);
  store_.set_retry(point.key, verdict.retries_used, verdict.retry_in_s > 0 ? now_unix_s() + verdict.retry_in_s : 0);
  store_.change_state(point.key, now.state, verdict.state, verdict.evidence, attempt.number);
  outcome.commit();
  if (trouble != LaunchTrouble::files) {
    // What all points share is not where they lie.
    std::string reason = why;
    for (std::size_t at; (at = reason.find(point.key)) != std::string::npos;) reason.replace(at, point.key.size(), "*");
    note_failure(point.key, reason);
  }
  say_(fmt::format("{}: {} ({})", name_of(point), word_of(verdict.state), verdict.evidence));
}

void Manager::ask_to_stop() {
  for (const LivingJob& job : living_) {
    if (!job.is_seen || job.job) continue;
    try {
      executor_.ask_to_stop(job.process, run_directory(job.key), job.attempt);
      make_stop_file(run_directory(job.key));
    } catch (const std::exception& error) {
      warn_of({fmt::format("#{}: {}", job.ordinal, error.what())});
    }
  }
}

bool Manager::has_local_jobs() const {
  return std::any_of(living_.begin(), living_.end(), [](const LivingJob& job) { return job.is_seen && !job.job; });
}

bool Manager::has_work() const {
  const bool is_alive = std::any_of(living_.begin(), living_.end(), [](const LivingJob& job) { return job.is_seen; });
  if (is_alive || is_paused()) return is_alive;
  std::vector<Startable> points = startables();
  // What another host may be running is waited for by nobody: the user was told what to do.
  std::erase_if(points, [](const Startable& point) { return point.has_live_process; });
  return campaign::has_work(points);
}

double Manager::next_retry_in_s() const {
  const double now = now_unix_s();
  const double next = next_retry(startables(), now);
  return next > 0 ? next - now : 0;
}

}  // namespace rouleau::campaign
