// SPDX-License-Identifier: BSD-3-Clause
// Which cores of this machine are ours, which are taken, which a new job gets.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace rouleau::campaign {

/// Core numbers, ascending.
using Cores = std::vector<int>;

/// The cores that this process may use (a container or taskset may give fewer than the machine has).
[[nodiscard]] Cores allowed_cores();

/// The cores that a living process is pinned to; empty if it is gone.
[[nodiscard]] Cores cores_of(pid_t pid);

/// What a living job takes.
struct Occupant {
  Cores cores;    ///< the affinity of its process
  int ranks = 1;  ///< so many of them are busy
};

/// The allowed cores that no occupant takes. A job that is not pinned (more cores than ranks) takes as many as it has
/// ranks, from the end.
[[nodiscard]] Cores free_cores(const Cores& allowed, const std::vector<Occupant>& occupants);

/// The cores that solvers are pinned to, whichever campaign or user they belong to: as far as /proc shows them.
[[nodiscard]] Cores cores_of_solvers();

/// The same cores, those that nobody is pinned to first: campaigns that know nothing of each other shall not crowd on
/// the lowest.
[[nodiscard]] Cores quiet_first(Cores cores, const Cores& busy);

/// "0,1,5"
[[nodiscard]] std::string to_text(const Cores& cores);

/// Pins the calling process.   returns whether it worked
bool pin_to(const Cores& cores);

}  // namespace rouleau::campaign
