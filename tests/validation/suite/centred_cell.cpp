// SPDX-License-Identifier: BSD-3-Clause
// A cell on the channel axis stays there: any order in which vertices, nodes or ranks are summed would push it aside.
#include <fmt/format.h>

#include <algorithm>

#include "campaign_run.hpp"
#include "cases.hpp"

namespace rouleau::validation {

void centred_cell(Suite& suite) {
  for (const CampaignPoint& point : run_campaign(suite.places(), "centred_cell")) {
    const std::vector<double>& d_um = point.series("d_um");
    const double farthest = *std::max_element(d_um.begin(), d_um.end()) / point.number("node_spacing_um");
    const double steps = point.series("step").back();
    suite.check(fmt::format("lambda {:g}, {:g} steps: largest distance from the axis, dx in 1e5 steps",
                            point.number("lambda"), steps),
                farthest * 1e5 / steps, at_most(1e-3), "symmetry");
  }
}

}  // namespace rouleau::validation
