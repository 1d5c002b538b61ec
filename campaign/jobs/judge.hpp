// SPDX-License-Identifier: BSD-3-Clause
// What became of a point: from what was recorded, what runs, and what its directory proves, to its state. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jobs/slurm_state.hpp"
#include "jobs/state.hpp"

namespace rouleau::campaign {

/// What is known of the process of the newest attempt.
enum class Life {
  none,     ///< it was never started: no process.json
  alive,    ///< host, boot, pid and start time agree
  dead,     ///< it ran here and is gone
  unknown,  ///< another host, or the engine is silent
};

/// The end of an attempt by its own exit.json.
struct ExitRecord {
  int code = 0;
  std::string reason;
  std::int64_t start_step = 0;
  std::int64_t step = 0;
};

/// What the run directory proves, about its newest attempt.
struct Evidence {
  int newest_attempt = 0;  ///< the highest folder in attempts/; 0 = none
  Life life = Life::none;
  std::optional<ExitRecord> exit;       ///< of the newest attempt
  std::int64_t newest_checkpoint = -1;  ///< its step; -1 = none
  std::string last_words;               ///< last line of the newest attempt's stderr; for the reader only
  Cause cause = Cause::none;            ///< what the scheduler says of an end without exit.json
  bool can_never_start = false;         ///< the scheduler will never start such a job
  std::string engine_words;             ///< the scheduler's side of it, in plain words; "" = it has none
  std::string sample_trouble;           ///< what the samples lack of a run that says it is finished; "" = nothing
};

/// What was recorded before.
struct Recorded {
  State state = State::waiting;
  int attempt = 0;                        ///< the newest attempt recorded; 0 = none
  bool attempt_is_open = false;           ///< its end was not recorded yet
  std::int64_t checkpoint_at_start = -1;  ///< newest checkpoint when it was started; -1 = none
  int retries_used = 0;
  std::int64_t end_step = 0;  ///< steps of the run as the study asks for it now; 0 = not known
  int starts_in_vain =
      1;  ///< how many of the newest attempts, this one included, had the same checkpoint to start from
};

/// How often and how fast to retry; from the study's [execution].
struct RetryPolicy {
  int retries = 3;
  double retry_delay_s = 10;
  double io_retry_delay_s = 60;
};

/// What is to be recorded now. Equal to what was recorded: nothing happened.
struct Verdict {
  State state = State::waiting;
  bool attempt_ended = false;  ///< the newest attempt is over: record its end
  int retries_used = 0;
  double retry_in_s = 0;  ///< not to be started again before so long from now
  std::string evidence;   ///< why, for `rouleau why`; empty if nothing changed
};

/// Judges one point by share/contract.md section 6:
///
///     exit.json 0 -> done   75 -> stopped   65 -> refused   70 -> failed   74 -> crashed, long pause
///     76, anything else, or no exit.json -> crashed: retried at once after progress, else counted and delayed
///
/// "Progress" is a checkpoint newer than the one that the attempt was started from. A process that is alive or unknown
/// without an exit record changes nothing: silence is not evidence. A run that says 0 without all of its samples is not
/// done: it is counted and goes back to a checkpoint that counts only sound ones.
///
/// Ends that are not the run's doing (74; preempted, node lost, failed launch, forgotten job) are retried for ever,
/// without being counted: each time without progress after a longer pause. What can never start is refused.
///
/// An attempt that was planned but for which nothing was ever started (its manager died in between) is taken back
/// without being counted.
[[nodiscard]] Verdict judge(const Recorded& recorded, const Evidence& evidence, const RetryPolicy& policy);

/// Why an attempt could not be started.
enum class LaunchTrouble {
  files,   ///< its directory could not be written: disk, quota, medium
  engine,  ///< the system or the scheduler did not start the program
  damage,  ///< point.json or run.ini is not what `init` wrote
};

/// The same for an attempt that was never started: delayed like a file error. Damage is counted, for no waiting mends
/// it; anything else is not.
[[nodiscard]] Verdict judge_failed_launch(const Recorded& recorded, LaunchTrouble trouble, const std::string& why,
                                          const RetryPolicy& policy);

[[nodiscard]] bool has_progressed(const Recorded& recorded, const Evidence& evidence);

/// Whether an end is one that many points may share because something common is wrong with them: bad, without progress,
/// and neither a file error nor a lost node, which are waited out.
[[nodiscard]] bool is_early_failure(const Recorded& recorded, const Evidence& evidence, const Verdict& verdict);

}  // namespace rouleau::campaign
