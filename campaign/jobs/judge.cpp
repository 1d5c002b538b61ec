// SPDX-License-Identifier: BSD-3-Clause
// The judgement of a point.
#include "jobs/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rouleau::campaign {

namespace {

constexpr double longest_delay_s = 3600;
constexpr double crash_growth = 2;
constexpr double io_growth = 4;

// Exit codes of the solver, share/contract.md section 6.
constexpr int run_finished = 0;
constexpr int bad_input = 65;
constexpr int physics_failed = 70;
constexpr int io_failed = 74;
constexpr int run_stopped = 75;

double delay(double first_s, double growth, int retry) {
  constexpr int most_growths = 32;  // far beyond the longest, and no overflow
  return std::min(first_s * std::pow(growth, std::clamp(retry - 1, 0, most_growths)),
                  std::max(longest_delay_s, first_s));
}

std::string end_of(const Evidence& evidence) {
  if (evidence.exit) {
    return fmt::format("attempt {}: exit.json says {} ({}) at step {}", evidence.newest_attempt, evidence.exit->code,
                       evidence.exit->reason, evidence.exit->step);
  }
  std::string text = evidence.engine_words.empty()
                         ? fmt::format("attempt {}: its process is gone and left no exit.json", evidence.newest_attempt)
                         : fmt::format("attempt {}: {}; no exit.json", evidence.newest_attempt, evidence.engine_words);
  if (!evidence.last_words.empty()) text += fmt::format("; its last words: {}", evidence.last_words);
  return text;
}

bool is_file_error(const Evidence& evidence) { return evidence.exit && evidence.exit->code == io_failed; }

/// One more attempt without progress: a delayed retry, or the end of the retries.
Verdict counted(const Recorded& recorded, const RetryPolicy& policy, bool is_io, std::string evidence) {
  Verdict verdict{State::crashed, true, recorded.retries_used + 1, 0, std::move(evidence)};
  if (verdict.retries_used > policy.retries) {
    verdict.state = State::exhausted;
    verdict.retries_used = recorded.retries_used;
    verdict.evidence += fmt::format("; no progress, and all {} retries are used up", policy.retries);
    return verdict;
  }
  verdict.retry_in_s = is_io ? delay(policy.io_retry_delay_s, io_growth, verdict.retries_used)
                             : delay(policy.retry_delay_s, crash_growth, verdict.retries_used);
  verdict.evidence += fmt::format("; no progress, retry {} of {} in {:.4g} s", verdict.retries_used, policy.retries,
                                  verdict.retry_in_s);
  return verdict;
}

/// One more attempt without progress that is no fault of the run: a retry that does not count, later each time.
Verdict uncounted(const Recorded& recorded, const RetryPolicy& policy, bool is_io, std::string evidence) {
  const double retry_in_s = is_io ? delay(policy.io_retry_delay_s, io_growth, recorded.starts_in_vain)
                                  : delay(policy.retry_delay_s, crash_growth, recorded.starts_in_vain);
  return {State::crashed, true, recorded.retries_used, retry_in_s,
          evidence + fmt::format("; not counted as a retry, again in {:.4g} s", retry_in_s)};
}

/// Whether an end was brought about from outside the run.
bool is_from_outside(Cause cause) {
  return cause == Cause::preempted || cause == Cause::node || cause == Cause::launch || cause == Cause::unclear;
}

/// A crash, a file error, or a lost fence: retried, but only so often without progress.
Verdict crashed(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy) {
  if (has_progressed(recorded, evidence)) {
    // A full disk is waited out even after progress; the delay does not grow, for the progress is real.
    const double retry_in_s = is_file_error(evidence) ? policy.io_retry_delay_s : 0;
    return {State::crashed, true, 0, retry_in_s,
            end_of(evidence) + fmt::format("; it reached checkpoint {}, so it goes on", evidence.newest_checkpoint)};
  }
  if (is_file_error(evidence)) return uncounted(recorded, policy, true, end_of(evidence));
  if (!evidence.exit && is_from_outside(evidence.cause)) return uncounted(recorded, policy, false, end_of(evidence));
  // Whoever cancels a job wants it gone for a while.
  const bool is_to_wait = !evidence.exit && evidence.cause == Cause::cancelled;
  return counted(recorded, policy, is_to_wait, end_of(evidence));
}

Verdict never_started(const Recorded& recorded, const Evidence& evidence) {
  const State state = evidence.newest_checkpoint >= 0 ? State::stopped : State::waiting;
  return {state, true, recorded.retries_used, 0,
          fmt::format("attempt {} was planned, but no process was started for it", evidence.newest_attempt)};
}

/// Finished, but not all samples say so. A continuation passes over the checkpoints that count what is lost.
Verdict incomplete(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy) {
  const std::string what = fmt::format("{}; but {}", end_of(evidence), evidence.sample_trouble);
  if (evidence.newest_checkpoint >= 0) return counted(recorded, policy, false, what);
  return {State::refused, true, recorded.retries_used, 0,
          what + "; put the file back from a copy, or let `rouleau retry` compute the point anew"};
}

Verdict finished(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy) {
  const ExitRecord& exit = *evidence.exit;
  if (exit.step >= recorded.end_step && !evidence.sample_trouble.empty()) return incomplete(recorded, evidence, policy);
  if (exit.step >= recorded.end_step) return {State::done, true, 0, 0, end_of(evidence)};
  if (exit.step > exit.start_step) {
    return {State::stopped, true, 0, 0,
            end_of(evidence) + fmt::format("; the study asks for {} steps now, so it goes on", recorded.end_step)};
  }
  return {State::refused, true, recorded.retries_used, 0,
          end_of(evidence) + fmt::format("; but the run has {} steps, and it made none", recorded.end_step)};
}

Verdict ended(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy) {
  if (!evidence.exit) {
    if (evidence.can_never_start) {
      return {State::refused, true, recorded.retries_used, 0,
              end_of(evidence) + "; correct cluster.ini, then `rouleau retry`"};
    }
    return evidence.life == Life::none ? never_started(recorded, evidence) : crashed(recorded, evidence, policy);
  }
  const ExitRecord& exit = *evidence.exit;
  switch (exit.code) {
    case run_finished:
      return finished(recorded, evidence, policy);
    case bad_input:
      return {State::refused, true, recorded.retries_used, 0, end_of(evidence)};
    case physics_failed:
      return {State::failed, true, recorded.retries_used, 0, end_of(evidence)};
    case run_stopped: {
      // Stopping without a single step must not become a busy loop.
      const bool has_stepped = exit.step > exit.start_step;
      const double retry_in_s = delay(policy.retry_delay_s, crash_growth, recorded.starts_in_vain);
      return {State::stopped, true, has_stepped ? 0 : recorded.retries_used, has_stepped ? 0 : retry_in_s,
              end_of(evidence)};
    }
    default:
      return crashed(recorded, evidence, policy);
  }
}

}  // namespace

Verdict judge(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy) {
  Verdict same{recorded.state, false, recorded.retries_used, 0, ""};
  const bool is_foreign = evidence.newest_attempt > recorded.attempt;
  const bool is_open = recorded.attempt_is_open || is_foreign || recorded.state == State::running;
  if (!is_open) return same;

  if (evidence.life == Life::alive || (evidence.life == Life::unknown && !evidence.exit)) {
    // An attempt that somebody else started is adopted while it runs.
    if (is_foreign && evidence.life == Life::alive && recorded.state != State::cancelled) {
      same.state = State::running;
      same.evidence =
          fmt::format("attempt {} was found running; it was not started by this campaign's database{}{}",
                      evidence.newest_attempt, evidence.engine_words.empty() ? "" : ": ", evidence.engine_words);
    }
    return same;
  }

  Verdict verdict = ended(recorded, evidence, policy);
  if (recorded.state == State::cancelled) {
    verdict.state = State::cancelled;
    if (evidence.life != Life::none) verdict.evidence = end_of(evidence);  // there will be no retry to tell of
    verdict.retries_used = recorded.retries_used;
    verdict.retry_in_s = 0;
  }
  return verdict;
}

Verdict judge_failed_launch(const Recorded& recorded, LaunchTrouble trouble, const std::string& why,
                            const RetryPolicy& policy) {
  const std::string what = fmt::format("attempt {} could not be started: {}", recorded.attempt, why);
  return trouble == LaunchTrouble::damage ? counted(recorded, policy, true, what)
                                          : uncounted(recorded, policy, true, what);
}

bool has_progressed(const Recorded& recorded, const Evidence& evidence) {
  return evidence.newest_checkpoint > recorded.checkpoint_at_start;
}

bool is_early_failure(const Recorded& recorded, const Evidence& evidence, const Verdict& verdict) {
  const bool is_bad = verdict.state == State::crashed || verdict.state == State::exhausted ||
                      verdict.state == State::failed || verdict.state == State::refused;
  if (is_file_error(evidence) || !evidence.sample_trouble.empty()) return false;
  if (!evidence.exit && (evidence.cause == Cause::preempted || evidence.cause == Cause::node)) return false;
  return verdict.attempt_ended && is_bad && !has_progressed(recorded, evidence);
}

}  // namespace rouleau::campaign
