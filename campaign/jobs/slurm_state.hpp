// SPDX-License-Identifier: BSD-3-Clause
// What the states and reasons of Slurm mean for a job of ours, in a few cases and in plain words. Pure.
#pragma once

#include <string>
#include <string_view>

namespace rouleau::campaign {

/// Where a job stands, as far as Slurm says.
enum class Phase {
  pending,     ///< waits; Slurm will start it by itself
  held,        ///< waits until somebody releases it
  impossible,  ///< waits for ever: it asks for what there is not, or what it may not have
  running,     ///< runs, is about to, or is about to end; also every state that is not known here
  ended,       ///< Slurm has ended it; the run directory says how far the solver came
};

/// Why a job has ended or is held, as far as Slurm says.
enum class Cause {
  none,        ///< nothing is wrong
  unclear,     ///< Slurm does not say enough
  time_limit,  ///< the time limit or a deadline
  memory,
  preempted,
  node,    ///< a node or the system failed
  launch,  ///< Slurm could not start it (or its script was killed by a signal, which Slurm words alike)
  cancelled,
};

struct JobView {
  Phase phase = Phase::running;
  Cause cause = Cause::none;
  std::string words;  ///< "queued (waits for its turn: Priority)", "Slurm: out of memory on n1"
};

/// The view of one job as squeue shows it (%T, %r, %N). A state that is not known counts as running, since an end is
/// never guessed; a reason that is not known counts as waiting. Both are named in the words.
[[nodiscard]] JobView view_of(std::string_view state, std::string_view reason, std::string_view nodes);

}  // namespace rouleau::campaign
