// SPDX-License-Identifier: BSD-3-Clause
// A spherical capsule in weak shear against the small-deformation limit, which does not know the viscosity contrast.
#include <fmt/format.h>

#include <cmath>
#include <compare>
#include <map>

#include "capsule_point.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* theory = "D = 5/4 (2 + nu_s)/(1 + nu_s) Ca_G, nu_s = C/(1 + C) (Barthes-Biesel)";

/// To first order in the capillary number, for any viscosity contrast.
double small_deformation(double C, double capillary_number) {
  const double nu_s = C / (1 + C);
  return 1.25 * (2 + nu_s) / (1 + nu_s) * capillary_number;
}

}  // namespace

void capsule_small(Suite& suite) {
  const std::vector<CampaignPoint> points = run_campaign(suite.places(), "capsule_small");
  struct Kind {
    double C, Ca_G, nodes;
    auto operator<=>(const Kind&) const = default;
  };
  std::map<Kind, std::map<double, double>> D;  // by kind and lambda
  for (const CampaignPoint& point : points) {
    const CapsulePoint capsule(point);
    const Kind kind{point.number("area_ratio"), std::round(1e4 * capsule.capillary_number()) / 1e4,
                    capsule.nodes_per_radius()};
    const double found = D[kind][capsule.lambda()] = capsule.final_deformation();
    const std::string what =
        fmt::format("Ca_G {}, C {}, lambda {}, a = {:.3g} dx", kind.Ca_G, kind.C, capsule.lambda(), kind.nodes);
    // As published capsules scatter; the second order in Ca and the images 8 a away are in it.
    suite.check("D: " + what, found, near_relative(small_deformation(kind.C, capsule.capillary_number()), 0.05),
                theory);
    suite.figure("angle, degrees: " + what, point.series("angle_xz_deg").back(), "45 in the limit Ca -> 0");
  }
  for (const auto& [kind, by_lambda] : D)
    suite.check(fmt::format("D(lambda 5) / D(lambda 1), Ca_G {}, C {}, a = {:.3g} dx", kind.Ca_G, kind.C, kind.nodes),
                by_lambda.at(5) / by_lambda.at(1), near_relative(1, 0.03),
                "equal at first order in Ca (Barthes-Biesel)");
}

}  // namespace rouleau::validation
