// SPDX-License-Identifier: BSD-3-Clause
// What a viscous interior does to a Skalak capsule in strong shear: it deforms less, and later.
#include <fmt/format.h>

#include <map>

#include "capsule_point.hpp"
#include "cases.hpp"

namespace rouleau::validation {

void capsule_contrast(Suite& suite) {
  const std::vector<CampaignPoint> points = run_campaign(suite.places(), "capsule_contrast");
  std::map<double, std::map<double, CapsulePoint>> capsules;  // by Ca_G and lambda
  for (const CampaignPoint& point : points) {
    const CapsulePoint capsule(point);
    capsules[capsule.capillary_number()].emplace(capsule.lambda(), capsule);
    suite.figure(fmt::format("steady D, Ca_G {:.3g}, lambda {}", capsule.capillary_number(), capsule.lambda()),
                 capsule.final_deformation());
  }
  constexpr const char* trend = "lower and slower with lambda: Lac et al. 2004, Foessel et al. 2011";
  for (const auto& [Ca_G, by_lambda] : capsules) {
    const CapsulePoint &thin = by_lambda.at(1), &viscous = by_lambda.at(5);
    suite.check(fmt::format("D(lambda 1) - D(lambda 5), Ca_G {:.3g}", Ca_G),
                thin.final_deformation() - viscous.final_deformation(), between(0, 1), trend);
    suite.check(fmt::format("gamma t to 90 % of D, lambda 5 - lambda 1, Ca_G {:.3g}", Ca_G),
                viscous.strain_to_reach(0.9) - thin.strain_to_reach(0.9), between(0, 10), trend);
  }
}

}  // namespace rouleau::validation
