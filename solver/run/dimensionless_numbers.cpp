// SPDX-License-Identifier: BSD-3-Clause
#include "run/dimensionless_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rouleau {
namespace {

struct Section {
  double shortest = std::numeric_limits<double>::infinity();  // distance of the nearest pair of walls, nodes
  double hydraulic_diameter = 0;                              // 4 area / wetted perimeter
};

Section cross_section(const Lattice& lattice) {
  Section section;
  double inverse = 0;  // 1/y + 1/z over the walled axes
  for (const int axis : {1, 2}) {
    if (lattice.periodic[axis]) continue;
    section.shortest = std::min<double>(section.shortest, lattice.size[axis]);
    inverse += 1.0 / lattice.size[axis];
  }
  if (inverse > 0) section.hydraulic_diameter = 2 / inverse;
  return section;
}

// The magic number that places the walls: of TRT, or the one that MRT's rates make. The energy flux and the third-order
// moments are the odd ones; the worse of the two counts.
double wall_magic_number(const NumericsParameters& numerics, double tau) {
  if (numerics.collision == CollisionLaw::trt) return numerics.magic_lambda;
  const double q = (tau - 0.5) * (1 / numerics.omega_q - 0.5), m = (tau - 0.5) * (1 / numerics.omega_m - 0.5);
  return std::abs(q - 0.1875) > std::abs(m - 0.1875) ? q : m;
}

}  // namespace

double cell_radius(const LatticeParameters& lattice) {
  double radius = 0;
  for (const auto& c : lattice.cells) radius = std::max({radius, c.radius, c.semi_axes.maxCoeff()});
  return radius;
}

DimensionlessNumbers dimensionless_numbers(const RunFile& run, const LatticeParameters& lattice, const Units& units) {
  const RunParameters& p = run.parameters;
  const bool is_shear = p.flow.driving == Driving::shear;
  const Section section = cross_section(lattice.lattice);
  DimensionlessNumbers n;
  n.mach = lattice.max_velocity * std::numbers::sqrt3;
  n.inflation = units.effective_density_kg_per_m3() / p.fluid.density_kg_per_m3;

  // Lattice Reynolds numbers are the inflated ones: the lattice's density is 1, its viscosity nu_out.
  const double per_nu = 1 / (lattice.nu_out * n.inflation);
  const double radius = cell_radius(lattice);
  const double shear_rate = is_shear
                                ? units.rate(p.flow.shear_rate_per_s)
                                : (std::isfinite(section.shortest) ? 2 * lattice.max_velocity / section.shortest : 0);
  if (lattice.body_force > 0)
    n.reynolds_channel = lattice.max_velocity / lattice.max_to_mean * section.hydraulic_diameter * per_nu;
  n.reynolds_cell = (is_shear ? shear_rate * radius : lattice.max_velocity) * radius * per_nu;
  // Explicit coupling of a flat sheet in Stokes flow: membrane rates K q / (4 mu) and kappa_B q^3 / (4 mu) at q = pi /
  // dx are stable under Euler's scheme below 8 / pi and 8 / pi^3; under second-order Adams-Bashforth below half of
  // that.
  const double share = p.numerics.advection == Advection::adams_bashforth ? 0.5 : 1.0;
  n.area_limit = 2.5 * share;
  n.bending_limit = 0.26 * share;
  if (!lattice.cells.empty()) {
    n.capillary_flow = lattice.nu_out * lattice.max_velocity / lattice.moduli.kappa_S;
    n.capillary_shear = lattice.nu_out * shear_rate * radius / (lattice.moduli.kappa_S / 3);
    n.shear_number = lattice.moduli.kappa_S / lattice.nu_out;
    n.area_number = lattice.moduli.kappa_A / lattice.nu_out;
    n.bending_number = lattice.moduli.kappa_B / lattice.nu_out;
  }
  if (lattice.body_force > 0 && std::isfinite(section.shortest))
    n.wall_error =
        (16 * wall_magic_number(p.numerics, lattice.tau_out) - 3) / (3 * section.shortest * section.shortest);
  return n;
}

}  // namespace rouleau
