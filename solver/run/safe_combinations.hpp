// SPDX-License-Identifier: BSD-3-Clause
// The map of what holds: kernels and schemes of advection against the membrane's stiffness (studies/safe-combinations).
#pragma once

#include <string>

#include "run/parameters.hpp"

namespace rouleau {

/// What trial runs of a red blood cell in the paper's channel (dx = 1/3 um, 2880 and 5120 triangles) say of a kernel
/// with a scheme of advection, by the stiffness kappa_A dt^2 / (rho dx^3), which is kappa_A in lattice units.
struct TrialRuns {
  double held;             ///< the largest at which the cell was whole after 0.1 s; 0: none
  double lost;             ///< the smallest at which it was lost within 15 ms, or already at rest
  double lost_area_ratio;  ///< the largest C at which the cell was always lost within 50 ms, at any step; 0: none
};

/// The C that held for 0.1 s with every kernel. Of less, some cells were lost later, or with some kernels.
inline constexpr double held_area_ratio = 100;

TrialRuns trial_runs(KernelWidth kernel, Advection advection);

/// The choices of kernel and advection that held a membrane as stiff as this, as advice: "kernel = 4-point or ...";
/// empty if none did.
std::string choices_that_held(double stiffness);

/// A sentence, after a full stop, that names the kernels for a membrane as stiff as this; empty if the run has one of
/// them, if there is none, or without cells.
std::string kernel_remedy(const RunParameters& parameters, double stiffness);

/// What to do about a mesh that folded, collapsed or lost its area: the choices of this run that trial runs were lost
/// with, or a smaller time step.
std::string mesh_remedy(const RunParameters& parameters);

}  // namespace rouleau
