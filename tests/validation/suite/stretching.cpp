// SPDX-License-Identifier: BSD-3-Clause
// A red blood cell pulled at both ends against the optical tweezers' measured diameters.
#include <fmt/format.h>

#include <map>

#include "base/error.hpp"
#include "campaign_run.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

struct Band {
  double low, high;
};
struct Measured {
  double force_pN;
  Band axial_um, transverse_um;
};
constexpr Measured measured[] = {
    {0, {7.18, 8.58}, {7.18, 8.58}},      {19.4, {8.70, 10.45}, {5.64, 6.92}}, {46.6, {10.82, 12.97}, {4.29, 5.83}},
    {87.6, {12.58, 14.98}, {4.00, 5.27}}, {151, {14.43, 16.87}, {3.78, 4.99}},
};
constexpr double fitting_modulus = 7.5;  // kappa_S, uN/m: G_s = 2.5 uN/m (Dimitrakopoulos 2012)

const Measured& measured_at(double force_pN) {
  for (const Measured& m : measured)
    if (m.force_pN == force_pN) return m;
  fail(Exit::bad_input, "stretching: nothing was measured at {} pN; there are 0, 19.4, 46.6, 87.6, 151", force_pN);
}

}  // namespace

void stretching(Suite& suite) {
  const std::vector<CampaignPoint> points = run_campaign(suite.places(), "stretching");
  std::map<double, std::map<double, double>> axial_um;  // by force and modulus
  for (const CampaignPoint& point : points) {
    const double force_pN = point.number("force_pN"), kappa_S = point.number("shear_modulus_uN_per_m");
    const Measured& band = measured_at(force_pN);
    const double axial = point.series("extent_x_um").back(), transverse = point.series("extent_y_um").back();
    axial_um[force_pN][kappa_S] = axial;
    for (const auto& [name, value, expected] :
         {std::tuple("axial", axial, band.axial_um), std::tuple("transverse", transverse, band.transverse_um)}) {
      const std::string quantity = fmt::format("{} diameter, um, {} pN, kappa_S {} uN/m", name, force_pN, kappa_S);
      if (kappa_S == fitting_modulus)
        suite.check(quantity, value, between(expected.low, expected.high),
                    "band of HemoCell's reference-bounds.dat, taken for Mills et al. 2004");
      else
        suite.figure(quantity, value, fmt::format("measured band {} to {}", expected.low, expected.high));
    }
    const std::vector<double>& x = point.series("x_um");
    suite.check(fmt::format("drift of the centre, um, {} pN, kappa_S {} uN/m", force_pN, kappa_S), x.back() - x.front(),
                at_most(1e-3), "opposite forces sum to zero");
  }
  axial_um.erase(0);  // nothing pulls
  for (const auto& [force_pN, by_modulus] : axial_um)
    suite.check(fmt::format("axial diameter of the softest - of the stiffest, um, {} pN", force_pN),
                by_modulus.begin()->second - by_modulus.rbegin()->second, between(0, 10),
                "a softer cell gives more way");
}

}  // namespace rouleau::validation
