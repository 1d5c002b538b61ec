// SPDX-License-Identifier: BSD-3-Clause
// What a run directory proves about its newest attempt, gathered for the judge.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "executor/process.hpp"
#include "jobs/judge.hpp"
#include "store/rows.hpp"

namespace rouleau::campaign {

/// The judge's evidence and the process it is about.
struct Gathered {
  Evidence evidence;
  ProcessIdentity process;  ///< pid 0: none known
  int ranks = 1;
  std::vector<std::string> warnings;  ///< damaged files
};

/// Says whether a process lives; an executor's `life`.
using LifeOf = std::function<Life(const ProcessIdentity&)>;

/// Reads a run directory. `recorded_attempt` is the newest attempt that the database knows (0 = none): if its folder is
/// not there yet, the evidence is about it all the same, and empty.
[[nodiscard]] Gathered gather(const std::filesystem::path& run_directory, int recorded_attempt, const LifeOf& life_of);

/// What the database knows, as the judge wants it.
[[nodiscard]] Recorded recorded_of(const PointRow& point, const AttemptRow* newest);

}  // namespace rouleau::campaign
