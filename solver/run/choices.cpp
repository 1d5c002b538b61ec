// SPDX-License-Identifier: BSD-3-Clause
#include "run/choices.hpp"

#include <algorithm>

#include "fluid/developed.hpp"

namespace rouleau {

namespace {

/// Steps between two updates of the driving force: short against the flow's own time, as long as that allows since each
/// needs a sum over all nodes.
int control_interval(double time_constant) { return static_cast<int>(std::clamp(time_constant / 20, 10.0, 100.0)); }

MrtRates<> named_rates(const NumericsParameters& n, double nu) {
  return {n.omega_e, n.omega_eps, n.omega_q, shear_rate_of(nu), n.omega_pi, n.omega_m};
}

}  // namespace

Collision collision_of(const Setup& setup) {
  const LatticeParameters& p = setup.lattice;
  const NumericsParameters& n = setup.run.parameters.numerics;
  if (n.collision == CollisionLaw::trt)
    return TwoFluids<TrtRates<>>{trt_rates(p.nu_out, n.magic_lambda), trt_rates(p.nu_in, n.magic_lambda)};
  return TwoFluids<MrtRates<>>{named_rates(n, p.nu_out), named_rates(n, p.nu_in)};
}

Kernel kernel_of(const Setup& setup) {
  switch (setup.run.parameters.numerics.kernel) {
    case KernelWidth::two_point:
      return Kernel::two_point;
    case KernelWidth::three_point:
      return Kernel::three_point;
    case KernelWidth::four_point:
      break;
  }
  return Kernel::four_point;
}

std::optional<Tracking> tracking_of(const Setup& setup) {
  if (setup.run.parameters.cells.empty()) return std::nullopt;
  switch (setup.run.parameters.numerics.tracking) {
    case TrackingChoice::vertex_normals:
      return Tracking::vertex_normals;
    case TrackingChoice::vertex_normals_wide:
      return Tracking::vertex_normals_wide;
    case TrackingChoice::face_normals:
      return Tracking::face_normals;
    case TrackingChoice::off:
      break;
  }
  return std::nullopt;
}

std::optional<MeanVelocityController> controller_of(const Setup& setup) {
  if (setup.run.parameters.flow.driving != Driving::mean_velocity) return std::nullopt;
  const LatticeParameters& p = setup.lattice;
  const double time_constant = DevelopedFlow(p.lattice).mean() / p.nu_out;
  return MeanVelocityController(p.mean_velocity, time_constant, control_interval(time_constant));
}

std::array<std::array<Vec3, 2>, 3> wall_velocities_of(const Setup& setup) {
  std::array<std::array<Vec3, 2>, 3> walls;
  for (auto& sides : walls) sides.fill(Vec3::Zero());
  walls[2] = {Vec3(-setup.lattice.wall_velocity, 0, 0), Vec3(setup.lattice.wall_velocity, 0, 0)};
  return walls;
}

}  // namespace rouleau
