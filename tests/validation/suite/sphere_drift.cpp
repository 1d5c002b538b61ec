// SPDX-License-Identifier: BSD-3-Clause
// A stiff sphere off the middle of a flow at small Reynolds number: Stokes flow is reversible, so it must not drift.
//
// What is stiff still deforms, and a deformed body does drift, by a share of its velocity that goes with the capillary
// number, so with the velocity. Two velocities tell this part, and leave that of a rigid sphere.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "campaign_run.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* reversibility = "reversibility of Stokes flow [Bretherton1962]";

struct Drift {
  double velocity_mm_per_s = 0, share = 0;  ///< share: velocity towards the middle over that along
};

/// From the last four fifths of the run: in the first the sphere takes up the flow's stress.
Drift drift_of(const CampaignPoint& point) {
  const std::vector<double>&time_s = point.series("time_s"), &x = point.series("x_um"), &d = point.series("d_um");
  std::size_t from = 0;
  while (time_s[from] < 0.2 * time_s.back()) ++from;
  const double path_um = x.back() - x[from];
  return {path_um / (time_s.back() - time_s[from]) * 1e-3, (d[from] - d.back()) / path_um};
}

}  // namespace

void sphere_drift(Suite& suite) {
  for (const char* study : {"sphere_drift_channel", "sphere_drift_shear"}) {
    std::map<double, std::vector<Drift>> by_lambda;
    for (const CampaignPoint& point : run_campaign(suite.places(), study)) {
      const Drift drift = drift_of(point);
      suite.figure(fmt::format("{}, lambda {:g}: drift towards the middle / velocity, at {:.3g} mm/s", study,
                               point.number("lambda"), drift.velocity_mm_per_s),
                   drift.share);
      by_lambda[point.number("lambda")].push_back(drift);
    }
    for (const auto& [lambda, drifts] : by_lambda) {
      const Drift &a = drifts.at(0), &b = drifts.at(1);
      const double rigid =
          (a.velocity_mm_per_s * b.share - b.velocity_mm_per_s * a.share) / (a.velocity_mm_per_s - b.velocity_mm_per_s);
      suite.check(fmt::format("{}, lambda {:g}: drift / velocity, at capillary number 0", study, lambda), rigid,
                  at_most(1e-4), reversibility);
    }
  }
}

}  // namespace rouleau::validation
