// SPDX-License-Identifier: BSD-3-Clause
#include "run/lattice_parameters.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "fluid/developed.hpp"
#include "run/value_text.hpp"

namespace rouleau {
namespace {

constexpr int fewest_nodes = 4;      // along an axis: the widest kernel must not meet itself
constexpr double most_nodes = 1e9;   // the flow rate's integer sums are exact up to here
constexpr double most_steps = 1e15;  // a step count stays exact in double precision

int whole_nodes(const RunFile& run, const Units& units, std::string_view axis, double length_um) {
  const std::string name = fmt::format("channel.length_{}_um", axis);
  const double nodes = units.length(length_um), nearest = std::round(nodes);
  if (nodes > most_nodes)
    fail(Exit::bad_input,
         "{}: {} = {} is {:.0f} node spacings of {} um; at most 1e9 nodes are possible. Raise node_spacing_um",
         run.where(name), name, canonical(length_um), nodes, canonical(units.dx_um()));
  if (std::abs(nodes - nearest) > 1e-6) {
    const double below = std::floor(nodes), above = below + 1;
    fail(Exit::bad_input,
         "{}: {} = {} is {:.6g} node spacings of {} um, not a whole number; the nearest lengths that fit are {} "
         "({:.0f} nodes) and "
         "{} ({:.0f} nodes)",
         run.where(name), name, canonical(length_um), nodes, canonical(units.dx_um()),
         canonical(units.length_um(below)), below, canonical(units.length_um(above)), above);
  }
  if (nearest < fewest_nodes)
    fail(Exit::bad_input, "{}: {} = {} is {:.0f} node spacings; at least {} are needed. Lower node_spacing_um",
         run.where(name), name, canonical(length_um), nearest, fewest_nodes);
  return static_cast<int>(nearest);
}

Lattice lattice_of(const RunFile& run, const Units& units) {
  const auto& channel = run.parameters.channel;
  Lattice lattice;
  lattice.size = {whole_nodes(run, units, "x", channel.length_x_um), whole_nodes(run, units, "y", channel.length_y_um),
                  whole_nodes(run, units, "z", channel.length_z_um)};
  lattice.periodic = {true, channel.boundary_y == Boundary::periodic, channel.boundary_z == Boundary::periodic};
  if (static_cast<double>(lattice.size[0]) * lattice.size[1] * lattice.size[2] > most_nodes)
    fail(Exit::bad_input, "{}: the lattice has {} x {} x {} nodes; at most 1e9 are possible. Raise node_spacing_um",
         run.where("numerics.node_spacing_um"), lattice.size[0], lattice.size[1], lattice.size[2]);
  return lattice;
}

void set_flow(LatticeParameters& result, const FlowParameters& flow, const Units& units) {
  std::optional<DevelopedFlow> developed;  // without walls the flow never develops
  if (!result.lattice.periodic[1] || !result.lattice.periodic[2]) developed.emplace(result.lattice);
  result.initial_velocity = units.speed(flow.initial_velocity_mm_per_s);
  result.max_velocity = result.initial_velocity;
  switch (flow.driving) {
    case Driving::mean_velocity:
      result.mean_velocity = units.speed(flow.mean_velocity_mm_per_s);
      if (developed) result.body_force = result.mean_velocity * result.nu_out / developed->mean();
      break;
    case Driving::pressure_gradient:
      result.body_force = units.force_density(flow.pressure_gradient_Pa_per_m);
      break;
    case Driving::shear:
      result.wall_velocity = 0.5 * units.rate(flow.shear_rate_per_s) * result.lattice.size[2];
      result.max_velocity = result.wall_velocity;
      break;
    case Driving::rest:
      break;
  }
  if (result.body_force > 0 && developed) {
    result.max_to_mean = developed->maximum() / developed->mean();
    result.max_velocity = result.body_force / result.nu_out * developed->maximum();
  }
}

StretchForce stretch_of(const StretchParameters& stretch, const Units& units) {
  StretchForce result;
  if (stretch.axis == StretchAxis::none) return result;
  result.axis = static_cast<std::size_t>(stretch.axis) - static_cast<std::size_t>(StretchAxis::x);
  result.force = units.force(stretch.force_pN);
  result.share = stretch.share;
  result.ramp_steps = stretch.ramp_ms * 1e3 / units.dt_us();
  return result;
}

// A number in [-1, 1) that depends on its arguments alone: SplitMix64 [Steele2014].
double displacement(std::int64_t replica, std::size_t cell, int axis) {
  std::uint64_t z =
      static_cast<std::uint64_t>(replica) * 0x9E3779B97F4A7C15u + (3 * cell + static_cast<std::uint64_t>(axis) + 1);
  for (int i = 0; i < 2; ++i) {
    z += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
  }
  return static_cast<double>(z >> 11) * 0x1p-52 - 1.0;
}

// Largest distance of the red blood cell's surface from its centre plane normal to `direction` (a unit vector in the
// cell's frame), for R = 1. Paper Eqs. 14, 15: z = +-(c0 + c2 r^2 - c4 r^4) sqrt(1 - r^2) / 2.
double red_blood_cell_support(const Vec3& direction) {
  const double across = std::hypot(direction[0], direction[1]), along = std::abs(direction[2]);
  double largest = 0;
  constexpr int samples = 2000;  // the maximum is quadratic: the error is below 1e-6
  for (int i = 0; i <= samples; ++i) {
    const double r = std::sin(0.5 * std::numbers::pi * i / samples), r2 = r * r;
    const double z = 0.5 * (0.207 + 2.00 * r2 - 1.12 * r2 * r2) * std::sqrt(1 - r2);
    largest = std::max(largest, r * across + z * along);
  }
  return largest;
}

Vec3 half_extent(const CellPlacement& placement, Shape shape) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(placement.rotation_angle, placement.rotation_axis).toRotationMatrix();
  Vec3 extent = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = rotation.row(axis).transpose();  // the lattice axis, seen by the cell
    if (shape == Shape::sphere) extent[axis] = placement.radius;
    if (shape == Shape::ellipsoid) extent[axis] = direction.cwiseProduct(placement.semi_axes).norm();
    if (shape == Shape::red_blood_cell) extent[axis] = placement.radius * red_blood_cell_support(direction);
  }
  return extent;
}

std::string cell_parameter(std::size_t cell, std::string_view name) {
  return cell == 0 ? fmt::format("cell.{}", name) : fmt::format("cell.{}.{}", cell + 1, name);
}

CellPlacement placement_of(const RunFile& run, std::size_t index, const Lattice& lattice, const Units& units) {
  const CellParameters& cell = run.parameters.cells[index];
  CellPlacement placement;
  const double length_x_um = run.parameters.channel.length_x_um;
  if (cell.position_x_um > length_x_um) {
    const std::string name = cell_parameter(index, "position_x_um");
    fail(Exit::bad_input, "{}: {} = {} lies beyond the channel's length, {} um", run.where(name), name,
         canonical(cell.position_x_um), canonical(length_x_um));
  }
  const double length = cell.rotation_axis.norm();
  if (!(length > 0)) {
    const std::string name = cell_parameter(index, "rotation_axis");
    fail(Exit::bad_input, "{}: {} = {} has no direction; give a vector that is not zero", run.where(name), name,
         canonical(cell.rotation_axis));
  }
  if (cell.replica > 0 && cell.jitter_um == 0) {
    const std::string name = cell_parameter(index, "replica");
    fail(Exit::bad_input, "{}: {} = {} repeats replica 0 as long as jitter_um = 0; set jitter_um", run.where(name),
         name, cell.replica);
  }
  placement.rotation_axis = cell.rotation_axis / length;
  placement.rotation_angle = cell.rotation_angle_deg * std::numbers::pi / 180;
  placement.from_um = cell.scale / units.dx_um();
  if (cell.shape == Shape::red_blood_cell || cell.shape == Shape::sphere)
    placement.radius = cell.radius_um * placement.from_um;
  if (cell.shape == Shape::ellipsoid) placement.semi_axes = cell.semi_axes_um * placement.from_um;
  placement.centre = {units.coordinate(cell.position_x_um),
                      0.5 * (lattice.size[1] - 1) + units.length(cell.offset_y_um),
                      0.5 * (lattice.size[2] - 1) + units.length(cell.offset_z_um)};
  if (cell.replica > 0)
    for (int axis = 0; axis < 3; ++axis)
      placement.centre[axis] += units.length(cell.jitter_um) * displacement(cell.replica, index, axis);
  placement.half_extent = half_extent(placement, cell.shape);
  return placement;
}

}  // namespace

double StretchForce::in_step_after(std::int64_t steps_done) const {
  const double s = static_cast<double>(steps_done) / ramp_steps;
  return s < 1 ? force * (s * s * (3 - 2 * s)) : force;  // without a ramp s is not finite
}

LatticeParameters lattice_parameters(const RunFile& run, const Units& units) {
  const RunParameters& p = run.parameters;
  LatticeParameters result;
  result.lattice = lattice_of(run, units);
  result.nu_out = viscosity_from_tau(p.numerics.tau_plasma);
  result.nu_in = p.cells.empty() ? result.nu_out : p.fluid.lambda * result.nu_out;
  result.tau_out = tau_from_viscosity(result.nu_out);
  result.tau_in = tau_from_viscosity(result.nu_in);
  set_flow(result, p.flow, units);
  if (!p.cells.empty()) {
    const double kappa_S = to_kappa_S(p.membrane.shear_modulus_convention, p.membrane.shear_modulus_uN_per_m);
    result.moduli.kappa_S = units.tension(kappa_S);
    result.moduli.law = p.membrane.law;
    if (p.membrane.law == InPlaneLaw::skalak) result.moduli.kappa_A = p.membrane.area_ratio * result.moduli.kappa_S;
    result.moduli.kappa_B = units.energy(p.membrane.bending_modulus_J);
    result.stretch = stretch_of(p.stretch, units);
  }
  for (std::size_t c = 0; c < p.cells.size(); ++c) result.cells.push_back(placement_of(run, c, result.lattice, units));
  const double steps = p.time.end_time_s / (p.numerics.time_step_us * 1e-6);
  if (steps > most_steps || units.steps(p.time.end_time_s) < 1)
    fail(Exit::bad_input, "{}: time.end_time_s = {} is {:.3g} steps of {} us; 1 to {:.0e} are possible",
         run.where("time.end_time_s"), canonical(p.time.end_time_s), steps, canonical(units.dt_us()), most_steps);
  result.steps = units.steps(p.time.end_time_s);
  return result;
}

}  // namespace rouleau
