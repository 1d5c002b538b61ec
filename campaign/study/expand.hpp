// SPDX-License-Identifier: BSD-3-Clause
// From a study to its points: every combination is shown to the solver, which says what it is and whether it can run.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "study/check.hpp"
#include "study/run_file.hpp"

namespace rouleau::campaign {

/// A point of the study (key and ordinal still unset) and its run file.
struct Candidate {
  Point point;
  std::string run_file;  ///< with stored file names, as it will lie in points/<key>/
};

struct Expansion {
  std::vector<Candidate> candidates;  ///< of different identity, in the sweep's order
  NamedFiles files;
  std::vector<std::string> notes;  ///< entries that are one point; the solver's warnings, each once
  std::string solver_version, solver_git;
};

/// Asks `check` about every combination of the study.
/// throws Error (usage) with the solver's words and the study file's line at the first combination it refuses
[[nodiscard]] Expansion expand(const Study& study, const Checker& check);

/// The shortest beginning of `identity`, 12 digits or more, that is not in `taken`.
[[nodiscard]] std::string key_of(const std::string& identity, const std::set<std::string>& taken);

}  // namespace rouleau::campaign
