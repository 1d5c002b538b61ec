// SPDX-License-Identifier: BSD-3-Clause
#include "fixed_sphere.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "coupling/interpolate.hpp"
#include "coupling/spread.hpp"
#include "fluid/initial.hpp"
#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"

namespace rouleau::validation {
namespace {

constexpr double pi = std::numbers::pi;

/// Off the nodes and off all planes of symmetry, as a moving cell is.
Cells sphere_in(int box, double radius) {
  const Vec3 centre = Vec3::Constant(0.5 * box) + Vec3(0.13, 0.37, 0.21);
  Surface surface = sphere(Division::of_frequency(static_cast<int>(std::lround(radius))), radius);
  translate(surface, centre);
  const CellStart start{surface, std::nullopt};
  return assemble({&start, 1});
}

Lattice cube(int box) { return {{box, box, box}, {true, true, true}}; }

}  // namespace

FixedSphere::FixedSphere(Kernel kernel, double radius, int box, double nu, double mean_velocity)
    : nu_(nu),
      mean_velocity_(mean_velocity),
      block_(cube(box), testing::one_trt(nu)),
      cells_(sphere_in(box, radius)),
      stencils_(kernel, block_.fluid.lattice, block_.fluid.block, cells_.vertices()) {
  find_stencils(cells_, stencils_);
  set_uniform(block_.fluid, Vec3(mean_velocity, 0, 0), Vec3::Zero());
  for (std::size_t v = 0; v < cells_.vertices(); ++v) set(cells_.U, v, Vec3(mean_velocity, 0, 0));
}

void FixedSphere::step() {
  const double gain = 0.5 * nu_;  // below 1: a vertex answers within a few steps
  Vec3 total = Vec3::Zero();
  for (std::size_t v = 0; v < cells_.vertices(); ++v) {
    set(cells_.F, v, at(cells_.F, v) - gain * at(cells_.U, v));
    total += at(cells_.F, v);
  }
  block_.body_force = -total / static_cast<double>(block_.fluid.lattice.nodes());
  clear_touched(stencils_, block_.fluid.g);
  spread(cells_.F, stencils_, block_.fluid.g);
  block_.step({stencils_.rows, stencils_.segment_shift});
  // No halo of u: the sphere's stencils do not reach the faces of the cube.
  interpolate(block_.fluid.u, WallVelocities{}, stencils_, cells_.U);
}

double FixedSphere::settled_force() {
  const int box = block_.fluid.lattice.size[0];
  // The slowest mode of the cube decays in as many; patterns of force that the kernel hardly passes on take longer.
  const int round = static_cast<int>(std::max(50.0, box * box / (4 * pi * pi * nu_)));
  double before = 0;
  for (int n = 0; n < 100; ++n) {
    for (int i = 0; i < round; ++i) step();
    const double force = block_.body_force[0] * static_cast<double>(block_.fluid.lattice.nodes());
    if (std::abs(force - before) < 2e-4 * std::abs(force)) return force;
    before = force;
  }
  fail(Exit::physics, "the force on the sphere has not settled after {} steps: {}", 100 * round, before);
}

double FixedSphere::slip() const {
  double sum = 0;
  for (std::size_t v = 0; v < cells_.vertices(); ++v) sum += at(cells_.U, v).squaredNorm();
  return std::sqrt(sum / static_cast<double>(cells_.vertices())) / mean_velocity_;
}

double hasimoto_factor(double radius, double box) {
  const double phi = 4 * pi / 3 * std::pow(radius / box, 3);
  return 1 / (1 - 1.7601 * std::cbrt(phi) + phi - 1.5593 * phi * phi);
}

double hydrodynamic_radius(double force, double viscosity, double mean_velocity, double box) {
  double low = 0, high = 0.3 * box;  // the drag grows with the radius
  for (int i = 0; i < 60; ++i) {
    const double radius = 0.5 * (low + high);
    const bool is_small = 6 * pi * viscosity * radius * mean_velocity * hasimoto_factor(radius, box) < force;
    (is_small ? low : high) = radius;
  }
  return 0.5 * (low + high);
}

}  // namespace rouleau::validation
