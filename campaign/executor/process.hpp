// SPDX-License-Identifier: BSD-3-Clause
// Who a process is, so that it is found again after our own death and never mistaken for another with its number.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jobs/judge.hpp"

namespace rouleau::campaign {

/// A process is the same only if all four agree (share/contract.md section 7).
struct ProcessIdentity {
  std::string host;
  std::string boot_id;
  std::int64_t pid = 0;
  std::int64_t start_ticks = 0;

  friend bool operator==(const ProcessIdentity&, const ProcessIdentity&) = default;
};

[[nodiscard]] std::string host_name();
/// /proc/sys/kernel/random/boot_id: another one means that every process of before is gone.
[[nodiscard]] std::string boot_id();

/// The identity of a living process of this host, or nothing. A zombie does not live.
[[nodiscard]] std::optional<ProcessIdentity> identity_of(pid_t pid);

/// alive, dead, or unknown when it runs (or ran) on another host.
[[nodiscard]] Life life_of(const ProcessIdentity& process);

/// The JSON of process.json. `checkpoint_step` is the newest checkpoint at the start (-1 = none), for a rebuilt
/// database.
[[nodiscard]] std::string process_json(const ProcessIdentity& process, int ranks, std::int64_t checkpoint_step);

}  // namespace rouleau::campaign
