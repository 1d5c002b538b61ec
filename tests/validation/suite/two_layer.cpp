// SPDX-License-Identifier: BSD-3-Clause
// Flow of two fluids with a flat interface between them: the direct test of a viscosity that depends on the node.
#include <fmt/format.h>

#include <map>

#include "../analytic_flows.hpp"
#include "case_file.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

using testing::TwoFluidFlow;

constexpr const char* exact = "analytic: stress and velocity continuous";
constexpr const char* independent = "a two-dimensional lattice, another program; two digits known";

struct Law {
  std::string name;
  Collision collision;
  /// L2 errors of the Poiseuille profile that another program found, by nodes across; empty: the law is exact
  std::map<int, double> known_errors;
};

/// One relaxation time: both rates of TRT alike.
TrtRates<> bgk_rates(double nu) { return {shear_rate_of(nu), shear_rate_of(nu)}; }

std::vector<Law> laws(double nu_1, double nu_2) {
  return {{"TRT 3/16", testing::two_trt(nu_1, nu_2), {}},
          {"TRT 1/4", testing::two_trt(nu_1, nu_2, 0.25), {{10, 8.1e-3}, {20, 2.0e-3}, {40, 5.1e-4}}},
          {"MRT, ghost rates 1",
           TwoFluids<MrtRates<>>{mrt_rates(nu_1, 1, 1), mrt_rates(nu_2, 1, 1)},
           {{10, 2.8e-2}, {20, 7.1e-3}, {40, 1.8e-3}}},
          {"BGK", TwoFluids<TrtRates<>>{bgk_rates(nu_1), bgk_rates(nu_2)}, {{10, 0.154}, {20, 3.9e-2}, {40, 9.7e-3}}}};
}

void check_poiseuille(Suite& suite, const Law& law, TwoFluidFlow flow, const std::vector<double>& nodes) {
  double coarser = 0;
  int coarser_N = 0;
  for (const double N : nodes) {
    flow.N = static_cast<int>(N);
    const double error = testing::two_layer_poiseuille_error<double>(law.collision, flow);
    const std::string what = fmt::format("Poiseuille, {}, N {}: L2 error", law.name, flow.N);
    if (law.known_errors.empty()) {
      suite.check(what, error, at_most(1e-6), exact);
      continue;
    }
    if (const auto known = law.known_errors.find(flow.N); known != law.known_errors.end())
      suite.check(what, error, near_relative(known->second, 0.03), independent);  // half a unit of the second digit
    else
      suite.figure(what, error);
    if (coarser_N != 0)
      suite.check(fmt::format("Poiseuille, {}: order of convergence, N {} to {}", law.name, coarser_N, flow.N),
                  std::log(coarser / error) / std::log(N / coarser_N), between(1.9, 2.1),
                  "slips of walls and interface are of second order");
    coarser = error;
    coarser_N = flow.N;
  }
}

}  // namespace

void two_layer(Suite& suite) {
  CaseFile file(suite.places().studies / "two_layer.ini");
  TwoFluidFlow flow{.lambda = file.number("fluid", "lambda"), .nu_1 = file.number("fluid", "viscosity")};
  const std::vector<double> nodes = file.numbers("channel", "nodes");
  const std::vector<double> shifts = file.numbers("interface", "shifts"),
                            known_errors = file.numbers("interface", "errors_at_20_nodes");
  file.require_all_used();
  const double nu_2 = flow.lambda * flow.nu_1;

  for (const Law& law : laws(flow.nu_1, nu_2)) {
    for (const double N : nodes) {
      flow.N = static_cast<int>(N);
      suite.check(fmt::format("Couette, {}, N {}: largest error / U", law.name, flow.N),
                  testing::two_layer_couette_error<double>(law.collision, flow), at_most(1e-6), exact);
    }
    check_poiseuille(suite, law, flow, nodes);
  }

  const Collision trt = testing::two_trt(flow.nu_1, nu_2);
  flow.N = static_cast<int>(nodes.front());
  // Populations of 3e-4 rounded to 1.5e-11, in units of U = 1e-3, added up over the nodes and many steps.
  suite.check("Couette, TRT 3/16 in single precision: largest error / U",
              testing::two_layer_couette_error<float>(trt, flow), at_most(1e-5), exact);
  suite.check("Poiseuille, TRT 3/16 in single precision: L2 error",
              testing::two_layer_poiseuille_error<float>(trt, flow), at_most(1e-5), exact);
  flow.N = 20;  // a multiple of four: the core begins between two nodes
  suite.check("Poiseuille, TRT 3/16, core in a sheath: L2 error",
              testing::two_fluid_poiseuille_error<double>(trt, flow, testing::core_and_sheath,
                                                          [](double y) { return std::abs(y) < 0.5; }),
              at_most(1e-6), exact);

  for (std::size_t i = 0; i < shifts.size(); ++i) {
    flow.shift = shifts[i];
    suite.check(fmt::format("Couette, interface {} dx off the middle of the link, N 20: largest error / U", shifts[i]),
                testing::two_layer_couette_error<double>(trt, flow), near_relative(known_errors.at(i), 0.03),
                independent, "the price of a flag that is 0 or 1");
  }
}

}  // namespace rouleau::validation
