// SPDX-License-Identifier: BSD-3-Clause
// The rules of the header, one after the other.
#include "jobs/job_life.hpp"

#include <fmt/format.h>

namespace rouleau::campaign {

namespace {

// Exit codes of the solver after which a further start of the same job would do nothing new, share/contract.md
// section 6.
bool is_last_word(int code) { return code == 0 || code == 65 || code == 70 || code == 76; }

/// A status of 0 without an exit.json proves nothing: srun also ends with 0 when it loses a node, on which the solver
/// lives on.
bool has_told_its_end(const JobTrace& trace) { return trace.exit_code || trace.status.value_or(0) != 0; }

std::string end_words(const JobTrace& trace) {
  if (trace.exit_code || !trace.status) return "";
  return fmt::format("its launcher ended with status {}", *trace.status);
}

JobLife alive(std::string words) {
  JobLife life;
  life.words = std::move(words);
  return life;
}

JobLife over(Cause cause, std::string words) {
  JobLife life;
  life.life = Life::dead;
  life.cause = cause;
  life.words = std::move(words);
  return life;
}

JobLife pending(const JobTrace& trace, const JobView& view) {
  const bool is_failed_launch = view.phase == Phase::held && view.cause == Cause::launch;
  if (view.phase == Phase::impossible || is_failed_launch) {
    JobLife life = over(view.cause, view.words);
    life.can_never_start = view.phase == Phase::impossible;
    life.action = JobAction::cancel;
    return life;
  }
  if (view.phase == Phase::held && !trace.is_released) {
    JobLife life = alive("submitted");
    life.action = JobAction::release;
    return life;
  }
  JobLife life = alive(has_told_its_end(trace) ? view.words + "; goes on behind its checkpoint" : view.words);
  life.is_shown = true;
  life.is_waiting = true;
  return life;
}

JobLife unknown_to_scheduler(const JobTrace& trace, double patience_s) {
  if (has_told_its_end(trace)) return over(Cause::none, end_words(trace));
  if (!trace.is_submitted) {
    if (trace.since_intent_s <= submission_patience_s) return alive("not known yet whether it was submitted");
    JobLife never;
    never.life = Life::none;
    return never;
  }
  if (trace.silent_s <= patience_s) {
    return alive(fmt::format("Slurm does not know job {}; its directory changed {:.0f} s ago, waiting until {:.0f} s",
                             trace.job, trace.silent_s, patience_s));
  }
  return over(Cause::unclear,
              fmt::format("Slurm does not know job {} any more, and its directory has been silent for {:.0f} s",
                          trace.job, trace.silent_s));
}

}  // namespace

JobLife life_of_job(const JobTrace& trace, double patience_s) {
  if (trace.exit_code && is_last_word(*trace.exit_code)) return over(Cause::none, "");
  if (!trace.answered) return alive("Slurm does not answer");
  if (!trace.view) return unknown_to_scheduler(trace, patience_s);
  const JobView& view = *trace.view;
  if (view.phase == Phase::ended) {
    // FAILED says little: what the launcher ended with says that the solver ran, and crashed.
    const bool is_told = view.cause == Cause::unclear && trace.status;
    return over(is_told ? Cause::none : view.cause, trace.exit_code ? "" : view.words);
  }
  if (view.phase != Phase::running) return pending(trace, view);
  if (has_told_its_end(trace) && !trace.has_started_anew) return over(Cause::none, end_words(trace));
  JobLife life = alive(view.words);
  life.is_shown = true;
  return life;
}

}  // namespace rouleau::campaign
