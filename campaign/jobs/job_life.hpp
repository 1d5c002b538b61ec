// SPDX-License-Identifier: BSD-3-Clause
// Whether an attempt that was handed to a scheduler still lives: the scheduler's word weighed against the run
// directory. Pure.
#pragma once

#include <optional>
#include <string>

#include "jobs/judge.hpp"
#include "jobs/slurm_state.hpp"

namespace rouleau::campaign {

/// What is known of an attempt under a scheduler.
struct JobTrace {
  bool answered = false;          ///< the scheduler answered when it was asked last
  std::optional<JobView> view;    ///< of the attempt's job, if the scheduler knows it
  std::string job;                ///< its id, for the words; "" = not known
  std::optional<int> exit_code;   ///< of the attempt's exit.json
  std::optional<int> status;      ///< of the attempt's status file: what its launcher ended with
  bool is_submitted = false;      ///< its job's id is on record
  bool is_released = false;       ///< and so is its release
  bool has_started_anew = false;  ///< the job was started again since this attempt, or that cannot be told
  double silent_s = 0;            ///< since anything of the attempt changed in the run directory
  double since_intent_s = 0;      ///< from its plan to the scheduler's answer
};

/// What is to be done about the job itself.
enum class JobAction { none, release, cancel };

/// The judgement, and what it means for the point.
struct JobLife {
  Life life = Life::alive;
  Cause cause = Cause::none;
  bool can_never_start = false;
  JobAction action = JobAction::none;
  bool is_shown = false;    ///< the scheduler showed the job, and past our hold
  bool is_waiting = false;  ///< and it waits for its start
  std::string words;        ///< for status and why
};

/// The rules, in this order:
///
///   1. an end that no further start of the same job changes (exit.json 0, 65, 70, 76) is an end, whatever the
///   scheduler says
///   2. the scheduler did not answer: nothing changes, the attempt counts as alive
///   3. a pending job will start the attempt, or (requeued) go on behind its checkpoint: alive. A job that we submitted
///      held and did not release yet is released now; one that Slurm holds after a failed launch is cancelled and over;
///      one that can never start is cancelled and refused
///   4. the job runs: alive, unless exit.json or the status file tell the end of this attempt (others of its job go
///      on). Of a job that was started again since, they tell nothing: its script is about to claim the next attempt
///   5. the job has ended: so has the attempt
///   6. the scheduler does not know the job (forgotten, or not yet visible): over if exit.json or the status file says
///      so; else only after the run directory has been silent for `patience_s`. Absence alone is no proof.
///
/// An attempt whose submission is not on record (its manager died in between) and that no job answers to is given up
/// after `submission_patience_s`: a submission under way may still become visible.
[[nodiscard]] JobLife life_of_job(const JobTrace& trace, double patience_s);

inline constexpr double submission_patience_s = 60;

}  // namespace rouleau::campaign
