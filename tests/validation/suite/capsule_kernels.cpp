// SPDX-License-Identifier: BSD-3-Clause
// How much the width of the kernel changes the deformation of a capsule.
#include <fmt/format.h>

#include <algorithm>

#include "capsule_point.hpp"
#include "cases.hpp"

namespace rouleau::validation {

void capsule_kernels(Suite& suite) {
  const std::vector<CampaignPoint> points = run_campaign(suite.places(), "capsule_kernels");
  std::vector<double> D;
  for (const CampaignPoint& point : points) {
    const CapsulePoint capsule(point);
    D.push_back(capsule.final_deformation());
    suite.figure(fmt::format("steady D, {}, a = {:.3g} dx", point.text("kernel"), capsule.nodes_per_radius()),
                 D.back());
    suite.figure(fmt::format("angle, rad, {}", point.text("kernel")), capsule.final_angle_rad());
  }
  const auto [lowest, highest] = std::minmax_element(D.begin(), D.end());
  suite.check("largest D / smallest D - 1", *highest / *lowest - 1, between(0, 0.05),
              "the width acts as a changed radius (Krueger et al. 2011): a few percent at a of 8 dx");
}

}  // namespace rouleau::validation
