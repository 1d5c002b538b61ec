// SPDX-License-Identifier: BSD-3-Clause
// Everything a campaign came to, times and attempts aside: what must not depend on what went wrong on the way.
#pragma once

#include <string>
#include <vector>

#include "support/campaign_program.hpp"

namespace rouleau::testing {

struct CampaignOutcome {
  std::vector<rouleau::campaign::PointRow> points;
  std::vector<std::vector<rouleau::campaign::ParameterRow>> parameters;
  std::vector<std::vector<rouleau::campaign::SampleRow>> samples;
  std::vector<std::vector<rouleau::campaign::ResultRow>> results;
  std::vector<std::string> logs;  ///< samples.csv, byte for byte

  friend bool operator==(const CampaignOutcome&, const CampaignOutcome&) = default;
};

inline CampaignOutcome outcome_of(const CampaignProgram& program) {
  const rouleau::campaign::Store store = program.store();
  CampaignOutcome outcome;
  outcome.points = store.points();
  for (const rouleau::campaign::PointRow& point : outcome.points) {
    outcome.parameters.push_back(store.parameters(point.key));
    outcome.samples.push_back(store.samples(point.key));
    outcome.results.push_back(store.results(point.key));
    outcome.logs.push_back(content_of(program.campaign() / "points" / point.key / "samples.csv"));
  }
  return outcome;
}

}  // namespace rouleau::testing
