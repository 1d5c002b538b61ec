// SPDX-License-Identifier: BSD-3-Clause
// What `rouleau-solver check run.ini --format json` answers (share/contract.md section 2).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/point.hpp"

namespace rouleau::campaign {

/// The answer to a run file that can be run.
struct CheckReply {
  std::string identity;
  std::string version, git;  ///< of the solver
  std::vector<Parameter> parameters;
  RunFacts facts;
  std::vector<std::string> warnings;
};

/// The answer to any run file: `error` holds the solver's lines if it refused.
struct CheckOutcome {
  CheckReply reply;
  std::string error;  ///< empty: accepted
};

/// Asks the solver about the text of a run file.
using Checker = std::function<CheckOutcome(const std::string& run_file)>;

/// Reads the JSON object.   throws Error (failed) if it is none, or of another contract
[[nodiscard]] CheckReply parse_check(const std::string& json);

}  // namespace rouleau::campaign
