// SPDX-License-Identifier: BSD-3-Clause
// Reconciling: evidence to verdict to database.
#include "commands/manager.hpp"

#include <algorithm>

#include "commands/pause.hpp"
#include "executor/attempt.hpp"
#include "ingest/ingest.hpp"
#include "ingest/result_file.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

std::filesystem::path existing_campaign(const std::filesystem::path& directory) {
  if (!std::filesystem::exists(directory / "campaign.db")) {
    fail(Exit::not_found, "{}: is no campaign (it has no campaign.db). `rouleau init STUDY {}` makes one.",
         directory.string(), directory.string());
  }
  return std::filesystem::canonical(directory);
}

/// As `rouleau init` recorded it: what it says of retries and ranks must not come from a damaged text.
Study kept_study(const Store& store, const std::filesystem::path& directory) {
  const CampaignRow campaign = store.campaign();
  if (digest_of(campaign.study_text) != campaign.study_digest) {
    fail(Exit::damaged, "{}: the study file in it is not the one that was recorded; `rouleau rebuild` makes it anew.",
         store.database().file().string());
  }
  return parse_study(campaign.study_text, directory / "study.ini");
}

RetryPolicy policy_of(const Execution& execution) {
  return {static_cast<int>(execution.retries), execution.retry_delay_s, execution.io_retry_delay_s};
}

bool was_ever_started(const std::filesystem::path& run_directory) {
  std::error_code unseen;
  return !attempt_numbers(run_directory).empty() || std::filesystem::exists(run_directory / "samples.csv", unseen) ||
         unseen;
}

/// An attempt that somebody else made, from its files.
AttemptRow foreign_attempt(const std::filesystem::path& run_directory, const std::string& key, int number,
                           std::vector<std::string>& warnings) {
  AttemptRow attempt;
  attempt.point = key;
  attempt.number = number;
  attempt.token = read_first_line(attempt_directory(run_directory, number) / "owner").value_or("");
  attempt.state = AttemptState::launched;
  attempt.started_unix_s = now_unix_s();
  fill_from_files(attempt, run_directory, warnings);
  return attempt;
}

}  // namespace

Manager::Manager(const std::filesystem::path& directory, const std::string& verb, Say say, LockPatience patience)
    : directory_(existing_campaign(directory)),
      say_(std::move(say)),
      lock_(directory_, verb, patience),
      store_(Store::open(directory_ / "campaign.db")),
      study_(kept_study(store_, directory_)),
      policy_(policy_of(study_.execution)),
      breaker_(kept_breaker(store_, study_)),
      allowed_(allowed_cores()) {
  read_engine();
  const std::vector<AttemptRow> open = store_.open_attempts();
  const auto is_slurms = [](const AttemptRow& attempt) { return attempt.engine == slurm_engine; };
  if (engine_.name == slurm_engine || std::any_of(open.begin(), open.end(), is_slurms))
    open_slurm(cluster_file(directory_));
}

std::filesystem::path Manager::run_directory(const std::string& key) const { return point_directory(directory_, key); }

std::string Manager::name_of(const PointRow& point) {
  std::string& name = names_[point.key];
  if (name.empty()) {
    std::string swept;
    for (const ParameterRow& row : store_.parameters(point.key)) {
      if (row.swept) swept += (swept.empty() ? "" : ", ") + row.name + " = " + row.text;
    }
    name = fmt::format("#{} ({})", point.ordinal, swept.empty() ? point.key : swept);
  }
  return name;
}

void Manager::warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (said_.insert(warning).second) say_("warning: " + warning);
  }
}

const LivingJob* Manager::living_job(const std::string& key) const {
  const auto found = std::find_if(living_.begin(), living_.end(), [&](const LivingJob& job) { return job.key == key; });
  return found == living_.end() ? nullptr : &*found;
}

void Manager::reconcile(bool all) {
  executor_.reap();
  look_at_queue();
  if (all) breaker_ = kept_breaker(store_, study_);
  std::vector<LivingJob> before;
  before.swap(living_);
  try {
    look_at_points(all, before);
  } catch (const DatabaseError&) {
    // Of the points that were not come to, no more is known than before; that is what a stop is sent to.
    for (const LivingJob& job : before) keep_alive(job);
    throw;
  }
}

void Manager::keep_alive(const LivingJob& job) {
  if (living_job(job.key) == nullptr) living_.push_back(job);
}

void Manager::look_at_points(bool all, const std::vector<LivingJob>& before) {
  std::set<std::string> open;
  for (const AttemptRow& attempt : store_.open_attempts()) open.insert(attempt.point);
  for (const PointRow& point : store_.points()) {
    if (!all && !open.contains(point.key) && point.state != State::running) continue;
    // One bad run must not keep the others from being looked after.
    try {
      // Thousands of points may never have been started; most of a pass would be spent on finding nothing there.
      if (point.state == State::waiting && !was_ever_started(run_directory(point.key))) continue;
      settle(point);
      if (all && !is_final(point.state)) warn_of(ingest_point(store_, directory_, point.key).warnings);
      const bool is_done = store_.point(point.key)->state == State::done;
      if (all && is_done) finish(point.key);
    } catch (const DatabaseError&) {
      throw;
    } catch (const std::exception& error) {
      warn_of({name_of(point) + ": " + error.what()});
      // A job that could not be looked at lives as it did, or the manager might take its last one for ended and leave.
      for (const LivingJob& job : before)
        if (job.key == point.key) keep_alive(job);
    }
  }
}

void Manager::settle(const PointRow& point) {
  std::optional<AttemptRow> newest = store_.newest_attempt(point.key);
  Gathered gathered = gather_of(point, newest ? &*newest : nullptr);
  warn_of(gathered.warnings);
  if (gathered.job) follow_job(point, newest ? &*newest : nullptr, gathered);
  Evidence& evidence = gathered.evidence;
  Recorded recorded = recorded_of(point, newest ? &*newest : nullptr);
  // An attempt that the user has given up (its end is recorded) is waited for no more.
  const bool is_open = recorded.attempt_is_open || evidence.newest_attempt > recorded.attempt;
  if (is_open && evidence.life != Life::alive) recorded.starts_in_vain = starts_in_vain(store_.attempts(point.key));
  Verdict verdict = judge(recorded, evidence, policy_);
  if (verdict.attempt_ended && verdict.state == State::done) {
    evidence.sample_trouble = sample_trouble(store_, run_directory(point.key), point.key, evidence.exit->step);
    verdict = judge(recorded, evidence, policy_);
  }
  const bool is_unseen = is_open && evidence.life == Life::unknown && !evidence.exit && !is_final(point.state);
  if (evidence.life == Life::alive || is_unseen) {
    living_.push_back({point.key, point.ordinal, evidence.newest_attempt, gathered.ranks, !is_unseen, gathered.process,
                       gathered.job, evidence.engine_words});
  }
  if (is_unseen) {
    warn_of(
        {fmt::format("{}: attempt {} was started on host {}, which cannot be seen from here. If it is gone for good, "
                     "`rouleau retry #{}` starts the point again.",
                     name_of(point), evidence.newest_attempt, gathered.process.host, point.ordinal)});
  }
  if (!verdict.attempt_ended && verdict.evidence.empty()) return;

  record(point, newest ? &*newest : nullptr, gathered, verdict);
  if (verdict.attempt_ended) note_end(point, recorded, gathered, verdict);
}

void Manager::record(const PointRow& point, const AttemptRow* newest, const Gathered& gathered,
                     const Verdict& verdict) {
  // Samples first: a point that is recorded as done has all of them in the database.
  if (verdict.attempt_ended) warn_of(ingest_point(store_, directory_, point.key).warnings);
  Transaction transaction = store_.begin();
  add_unknown_attempts(point, newest == nullptr ? 0 : newest->number, gathered);
  if (verdict.attempt_ended) {
    for (AttemptRow& attempt : store_.attempts(point.key)) {
      if (attempt.state == AttemptState::ended) continue;
      std::vector<std::string> warnings;
      fill_from_files(attempt, run_directory(point.key), warnings);
      attempt.state = AttemptState::ended;
      if (!attempt.ended_unix_s) attempt.ended_unix_s = now_unix_s();
      store_.put_attempt(attempt);
    }
    store_.set_retry(point.key, verdict.retries_used, verdict.retry_in_s > 0 ? now_unix_s() + verdict.retry_in_s : 0);
  }
  if (!store_.change_state(point.key, point.state, verdict.state, verdict.evidence, gathered.evidence.newest_attempt)) {
    fail(Exit::failed, "point {} changed its state while it was being judged. Run `rouleau sync` again.", point.key);
  }
  transaction.commit();
  if (verdict.state == State::done) finish(point.key);
}

void Manager::add_unknown_attempts(const PointRow& point, int recorded_attempt, const Gathered& gathered) {
  std::vector<std::string> warnings;
  for (const int number : attempt_numbers(run_directory(point.key))) {
    if (number <= recorded_attempt) continue;
    AttemptRow attempt = foreign_attempt(run_directory(point.key), point.key, number, warnings);
    if (number < gathered.evidence.newest_attempt) attempt.state = AttemptState::ended;
    store_.put_attempt(attempt);
  }
  warn_of(warnings);
}

void Manager::note_end(const PointRow& point, const Recorded& recorded, const Gathered& gathered,
                       const Verdict& verdict) {
  say_(fmt::format("{}: {} ({})", name_of(point), word_of(verdict.state), verdict.evidence));
  // A stop file that was obeyed would stop the next start too; of a cancelled point it stays until `retry`.
  if (verdict.state != State::cancelled) remove_stop_file(run_directory(point.key));
  const Evidence& evidence = gathered.evidence;
  if (verdict.state == State::done || has_progressed(recorded, evidence)) {
    note_progress();
  } else if (is_early_failure(recorded, evidence, verdict)) {
    note_failure(point.key, evidence.exit ? fmt::format("exit {}: {}", evidence.exit->code, evidence.exit->reason)
                                          : "crashed: " + evidence.last_words);
  }
}

void Manager::note_failure(const std::string& key, const std::string& reason) {
  breaker_.note_failure(key, reason);
  keep(store_, breaker_);
}

void Manager::note_progress() {
  if (breaker_.count() == 0 || breaker_.has_tripped()) return;
  breaker_.note_progress();
  keep(store_, breaker_);
}

void Manager::finish(const std::string& key) {
  warn_of(ingest_point(store_, directory_, key).warnings);
  write_result_file(store_, directory_, key);
}

void Manager::ingest_living() {
  for (const LivingJob& job : living_) {
    try {
      warn_of(ingest_point(store_, directory_, job.key).warnings);
    } catch (const DatabaseError&) {
      throw;
    } catch (const std::exception& error) {
      warn_of({fmt::format("#{}: {}", job.ordinal, error.what())});
    }
  }
}

void Manager::take_requests() {
  std::vector<std::string> warnings;
  for (const Request& request : requests_in(directory_, warnings)) {
    if (const std::optional<PointRow> point = store_.point(request.key)) {
      try {
        request.wish == Wish::cancel ? cancel(*point) : retry(*point);
      } catch (const DatabaseError&) {
        throw;  // the request stays for the next pass
      } catch (const Error& error) {
        say_(name_of(*point) + ": " + error.what());
      }
    }
    std::filesystem::remove(request.file);
  }
  warn_of(warnings);
}

void Manager::cancel(const PointRow& point) {
  if (point.state == State::done || point.state == State::cancelled) {
    say_(fmt::format("{}: is {}; there is nothing to cancel", name_of(point), word_of(point.state)));
    return;
  }
  // The directory first: it is the truth that a rebuilt database comes from.
  Point file = read_point(run_directory(point.key) / "point.json");
  file.cancelled = true;
  write_point(run_directory(point.key) / "point.json", file);
  make_stop_file(run_directory(point.key));
  store_.change_state(point.key, point.state, State::cancelled, "cancelled by the user");
  if (const std::optional<AttemptRow> newest = store_.newest_attempt(point.key);
      newest && newest->state != AttemptState::ended) {
    look_at_queue();
    const Gathered gathered = gather_of(point, &*newest);
    if (gathered.job)
      leave_queue(*newest, gathered);
    else
      executor_.ask_to_stop(gathered.process, run_directory(point.key), newest->number);
  }
  say_(name_of(point) + ": cancelled");
}

void Manager::retry(const PointRow& point) {
  if (point.state == State::done || point.state == State::waiting || point.state == State::stopped) return;
  const std::optional<AttemptRow> newest = store_.newest_attempt(point.key);
  const Gathered gathered = gather_of(point, newest ? &*newest : nullptr);
  // A running point is taken over only if nobody can say whether it still runs; its old attempt is fenced off.
  if (point.state == State::running && gathered.evidence.life != Life::unknown) {
    say_(name_of(point) + ": is running; there is nothing to retry");
    return;
  }
  Point file = read_point(run_directory(point.key) / "point.json");
  file.cancelled = false;
  file.retried_after = gathered.evidence.newest_attempt;
  write_point(run_directory(point.key) / "point.json", file);
  if (gathered.evidence.life != Life::alive) remove_stop_file(run_directory(point.key));
  Transaction transaction = store_.begin();
  if (point.state == State::running) {
    for (AttemptRow& attempt : store_.attempts(point.key)) {
      if (attempt.state == AttemptState::ended) continue;
      attempt.state = AttemptState::ended;
      attempt.ended_unix_s = now_unix_s();
      attempt.reason = "given up by the user: its host cannot be seen";
      store_.put_attempt(attempt);
    }
  }
  store_.set_retry(point.key, 0, 0);
  const State next = gathered.evidence.newest_checkpoint >= 0 ? State::stopped : State::waiting;
  store_.change_state(point.key, point.state, next, "retry asked for by the user");
  said_.erase(pause_text(breaker_));  // the next pause is another one
  breaker_.reset();                   // who retries has corrected the common cause
  keep(store_, breaker_);
  transaction.commit();
  say_(name_of(point) + ": will be started again");
}

StateCounts Manager::counts() const {
  StateCounts counts;
  for (const PointRow& point : store_.points()) {
    if (point.in_study) ++counts[point.state];
  }
  return counts;
}

}  // namespace rouleau::campaign
