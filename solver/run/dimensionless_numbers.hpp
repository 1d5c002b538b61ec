// SPDX-License-Identifier: BSD-3-Clause
// The dimensionless numbers of a run: of its physics, and of its discretisation.
#pragma once

#include "run/lattice_parameters.hpp"

namespace rouleau {

struct DimensionlessNumbers {
  double mach = 0;              ///< expected max velocity / lattice speed of sound
  double inflation = 0;         ///< Reynolds number of the run / physical one = rho_eff / rho
  double reynolds_channel = 0;  ///< rho u_mean D_h / mu, physical; 0 without channel flow
  double reynolds_cell = 0;    ///< rho u_max R / mu, physical (shear: rho gamma R^2 / mu); 0 without a flow or a radius
  double capillary_flow = 0;   ///< mu u_max / kappa_S; 0 without a cell
  double capillary_shear = 0;  ///< mu gamma R / G_s, gamma = u_max / half of the short side, or the shear rate
  double shear_number = 0;     ///< kappa_S dt / (mu dx)
  double area_number = 0;      ///< kappa_A dt / (mu dx)
  double bending_number = 0;   ///< kappa_B dt / (mu dx^3)
  double area_limit = 0;       ///< stability limit of the two numbers of kappa_S and kappa_A, for the advection chosen
  double bending_limit = 0;    ///< likewise of kappa_B
  double wall_error = 0;       ///< of u_max by where the collision puts the walls, (16 Lambda - 3) / (3 N^2), plasma
};

DimensionlessNumbers dimensionless_numbers(const RunFile& run, const LatticeParameters& lattice, const Units& units);

/// Largest radius or semi-axis of the placed shapes, lattice units; 0 where only meshes are given.
double cell_radius(const LatticeParameters& lattice);

}  // namespace rouleau
