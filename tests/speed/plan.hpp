// SPDX-License-Identifier: BSD-3-Clause
// What to measure, and how long.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "paper_point.hpp"

namespace rouleau::speed {

struct Plan {
  std::filesystem::path studies = "studies/paper";
  std::filesystem::path result = "build/benchmark.json";
  std::set<std::string> sections{"fluid", "coupled", "ranks", "jobs", "checkpoint", "sweep"};
  int rounds = 25;
  int steps = 500;         ///< of the coupled simulation in a batch: one correction of the interior comes in each
  double enough_s = 0.25;  ///< repeating a short case
  std::vector<int> edges{24, 36, 48, 60, 72, 84, 96};
  Changes changes;  ///< to the paper's point

  [[nodiscard]] bool wants(const std::string& section) const { return sections.contains(section); }
};

/// throws  Error(usage)
Plan parse_plan(int argc, char** argv);

}  // namespace rouleau::speed
