// SPDX-License-Identifier: BSD-3-Clause
#include "run/safe_combinations.hpp"

#include <fmt/format.h>

namespace rouleau {

// The time steps of the study are the paper's times 1, 2, 4 and 8, tau - 1/2 growing alike. At C = 100 the stiffness is
// then 0.0322, 0.129, 0.514 and 2.06; at C = 10 a tenth.
TrialRuns trial_runs(KernelWidth kernel, Advection advection) {
  // The narrow kernels feed the lattice's alternating momentum (coupling/advect.cpp), Adams-Bashforth twice as much.
  const double alternation = advection == Advection::adams_bashforth ? 0.5 : 1;
  const bool is_averaged = advection == Advection::averaged;
  switch (kernel) {
    case KernelWidth::two_point:
      if (is_averaged) return {0.13, 0.51, 1};
      return {0, alternation * 0.032, 0};
    case KernelWidth::three_point:
      if (is_averaged) return {0.52, 2.05, 1};
      return {0, alternation * 0.12, 0};
    case KernelWidth::four_point:
      break;
  }
  return {2.1, 3.2, 10};
}

std::string choices_that_held(double stiffness) {
  std::string text;
  const auto add = [&](KernelWidth kernel, Advection advection, const char* name) {
    if (trial_runs(kernel, advection).held >= stiffness) text += (text.empty() ? "" : " or ") + std::string(name);
  };
  add(KernelWidth::two_point, Advection::averaged, "kernel = 2-point with advection = averaged");
  add(KernelWidth::three_point, Advection::averaged, "kernel = 3-point with advection = averaged");
  add(KernelWidth::four_point, Advection::euler, "kernel = 4-point");
  return text;
}

std::string kernel_remedy(const RunParameters& parameters, double stiffness) {
  const NumericsParameters& n = parameters.numerics;
  if (parameters.cells.empty() || trial_runs(n.kernel, n.advection).held >= stiffness) return "";
  const std::string choices = choices_that_held(stiffness);
  return choices.empty() ? "" : ". In trial runs membranes as stiff as this held with " + choices;
}

std::string mesh_remedy(const RunParameters& parameters) {
  const NumericsParameters& n = parameters.numerics;
  const MembraneParameters& membrane = parameters.membrane;
  std::string text;
  const auto add = [&](bool is_lost_cause, const std::string& instead) {
    if (is_lost_cause) text += (text.empty() ? "" : ", ") + instead;
  };
  add(n.fold_resistance == 0, "numerics.fold_resistance = 2");
  add(n.mesh_mobility == 0, "numerics.mesh_mobility = 0.1");
  add(membrane.law == InPlaneLaw::skalak && membrane.area_ratio < held_area_ratio,
      fmt::format("membrane.area_ratio = {} or more", held_area_ratio));
  add(true, "a smaller numerics.time_step_us");
  return "Try " + text;
}

}  // namespace rouleau
