// SPDX-License-Identifier: BSD-3-Clause
// Starting: intent recorded, attempt claimed, process started, outcome recorded.
#include <algorithm>

#include "commands/manager.hpp"
#include "commands/pause.hpp"
#include "commands/planned_point.hpp"
#include "executor/attempt.hpp"
#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

/// A start needs room for the checkpoint being written aside, one more, and something for logs.
constexpr std::int64_t checkpoints_of_room = 2;
constexpr std::int64_t bytes_for_logs = 1 << 20;

double MiB_in(const std::filesystem::path& directory) {
  double bytes = 0;
  std::error_code vanished;  // a living job replaces files meanwhile
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory, vanished)) {
    const std::uintmax_t size = entry.is_regular_file(vanished) ? entry.file_size(vanished) : 0;
    if (!vanished) bytes += static_cast<double>(size);
  }
  return bytes / (1 << 20);
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
  return free_cores(allowed_, occupants);
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
  if (is_paused()) {
    warn_of({pause_text(breaker_)});
    return 0;
  }
  return engine_.name == slurm_engine ? submit() : start_here();
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
      const PlannedPoint planned = planned_point(read_point(run / "point.json"), point.state, 0);
      need_MiB += std::max(0.0, disk_MiB(planned) - MiB_in(run));
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

bool Manager::has_room_for(const PointRow& point) {
  const Point file = read_point(run_directory(point.key) / "point.json");
  const auto room = static_cast<std::int64_t>(std::filesystem::space(directory_).available);
  const std::int64_t need = checkpoints_of_room * file.facts.checkpoint_bytes + bytes_for_logs;
  if (room >= need) return true;
  warn_of({fmt::format("{}: the disk has {} MiB free, a start needs {} MiB. Points wait until there is room.",
                       directory_.string(), room >> 20, need >> 20)});
  return false;
}

AttemptRow Manager::planned_attempt(const PointRow& point, const Cores& cores) const {
  const std::vector<int> in_directory = attempt_numbers(run_directory(point.key));
  const std::vector<std::int64_t> checkpoints = checkpoint_steps(run_directory(point.key));
  const std::optional<AttemptRow> newest = store_.newest_attempt(point.key);
  AttemptRow attempt;
  attempt.point = point.key;
  attempt.number = 1 + std::max(in_directory.empty() ? 0 : in_directory.back(), newest ? newest->number : 0);
  attempt.token = new_token();
  attempt.state = AttemptState::planned;
  attempt.host = host_name();
  attempt.ranks = static_cast<int>(study_.execution.ranks);
  attempt.cores = to_text(cores);
  attempt.checkpoint_at_start = checkpoints.empty() ? -1 : checkpoints.back();
  attempt.started_unix_s = now_unix_s();
  return attempt;
}

bool Manager::start_point(const PointRow& point, const Cores& cores) {
  AttemptRow attempt = planned_attempt(point, cores);
  const std::string how = attempt.checkpoint_at_start < 0
                              ? "from the start"
                              : fmt::format("again, newest checkpoint on disk {}", attempt.checkpoint_at_start);
  const std::filesystem::path run = run_directory(point.key);
  ProcessIdentity process;
  std::string trouble;
  try {
    if (!has_room_for(point)) return false;
    require_run_file(run, read_point(run / "point.json"));
    Transaction intent = store_.begin();
    store_.put_attempt(attempt);
    const std::string evidence = fmt::format("attempt {} is started {}", attempt.number, how);
    if (!store_.change_state(point.key, point.state, State::running, evidence, attempt.number)) return false;
    intent.commit();

    remove_stop_file(run);
    claim_attempt(run, attempt.number, attempt.token);
    process = executor_.launch({solver_, run, attempt.number, attempt.token, attempt.ranks, attempt.checkpoint_at_start,
                                cores, static_cast<int>(study_.execution.niceness)});
  } catch (const Error& error) {
    record_failed_launch(point, attempt, error.what());
    return false;
  }
  // A process is running from here on: what fails now is no failed launch, and the next pass finds it by its
  // process.json.
  attempt.host = process.host;
  attempt.boot_id = process.boot_id;
  attempt.pid = process.pid;
  attempt.start_ticks = process.start_ticks;
  attempt.state = AttemptState::launched;
  store_.put_attempt(attempt);
  living_.push_back({point.key, point.ordinal, attempt.number, attempt.ranks, true, process, {}, ""});
  const char* where = cores.empty() ? "" : cores.size() > 1 ? ", on cores " : ", on core ";
  say_(fmt::format("{}: attempt {} started {}{}{}", name_of(point), attempt.number, how, where, to_text(cores)));
  return true;
}

void Manager::record_failed_launch(const PointRow& point, AttemptRow attempt, const std::string& why) {
  const PointRow now = store_.point(point.key).value();
  const Verdict verdict = judge_failed_launch(recorded_of(now, &attempt), why, policy_);
  Transaction outcome = store_.begin();
  attempt.state = AttemptState::ended;
  attempt.ended_unix_s = now_unix_s();
  attempt.reason = why;
  store_.put_attempt(attempt);
  store_.set_retry(point.key, verdict.retries_used, verdict.retry_in_s > 0 ? now_unix_s() + verdict.retry_in_s : 0);
  store_.change_state(point.key, now.state, verdict.state, verdict.evidence, attempt.number);
  outcome.commit();
  note_failure(point.key, why);
  say_(fmt::format("{}: {} ({})", name_of(point), word_of(verdict.state), verdict.evidence));
}

void Manager::ask_to_stop() {
  for (const LivingJob& job : living_) {
    if (!job.is_seen || job.job) continue;
    make_stop_file(run_directory(job.key));
    executor_.ask_to_stop(job.process, run_directory(job.key), job.attempt);
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
