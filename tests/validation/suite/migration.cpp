// SPDX-License-Identifier: BSD-3-Clause
// Deformable bodies off the axis of a channel go towards it, at Reynolds numbers too small for inertia to do that.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "campaign_run.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* migration_of_capsules = "deformable bodies leave the wall [Leal1980], [Losserand2019]";

/// Mean over a share of the series: from `begin` to `end` of its length.
double mean_of(const std::vector<double>& values, double begin, double end) {
  const auto at = [&](double share) { return values.begin() + static_cast<std::ptrdiff_t>(share * values.size()); };
  return std::accumulate(at(begin), at(end), 0.0) / static_cast<double>(at(end) - at(begin));
}

}  // namespace

void migration(Suite& suite) {
  for (const char* study : {"migration_sphere", "migration_cell"}) {
    std::vector<double> ends;
    for (const CampaignPoint& point : run_campaign(suite.places(), study)) {
      const std::vector<double>& d_um = point.series("d_um");
      const std::string what = fmt::format("{}, time step {:g} us", study, point.number("time_step_us"));
      ends.push_back(mean_of(d_um, 0.9, 1));
      double before = d_um.front(), largest_rise = 0;
      for (const double begin : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        const double now = mean_of(d_um, begin, begin + 0.2);
        largest_rise = std::max(largest_rise, now - before);
        before = now;
      }
      suite.check(what + ": distance from the axis at the end / at the start", ends.back() / d_um.front(),
                  between(0, 0.99), migration_of_capsules);
      const std::string rise = what + ": largest rise of it from one fifth of the run to the next / start";
      if (point.text("shape") == "sphere")
        suite.check(rise, largest_rise / d_um.front(), at_most(0), migration_of_capsules);
      else
        suite.figure(rise, largest_rise / d_um.front(), "a cell that turns over swings about its way");
    }
    suite.check(fmt::format("{}: distance at the end, half the Reynolds number over the whole", study),
                ends[1] / ends[0], near_relative(1, 0.05), "inertia plays no part");
  }
}

}  // namespace rouleau::validation
