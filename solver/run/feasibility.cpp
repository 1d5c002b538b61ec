// SPDX-License-Identifier: BSD-3-Clause
#include "run/feasibility.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/safe_combinations.hpp"
#include "run/value_text.hpp"

namespace rouleau {
namespace {

/// By how much the drag of a sphere of vertices exceeds that of its mesh, in radius, node spacings
/// (studies/validation).
double hydrodynamic_excess(KernelWidth kernel) {
  switch (kernel) {
    case KernelWidth::two_point:
      return 0.36;
    case KernelWidth::three_point:
      return 0.45;
    case KernelWidth::four_point:
      break;
  }
  return 0.63;
}

constexpr double slack = 1e-9;  // relative; limits that are met exactly in decimal must not fail by rounding

// One run under examination: refusals throw, warnings are gathered.
class Examination {
 public:
  Examination(const RunFile& run, const LatticeParameters& lattice, const Units& units)
      : run_(run),
        p_(run.parameters),
        lattice_(lattice),
        units_(units),
        n_(dimensionless_numbers(run, lattice, units)) {}

  std::vector<std::string> warnings() {
    check_flow();
    check_relaxation_times();
    check_mach();
    check_collision();
    check_snapshots();
    if (!p_.cells.empty()) {
      check_tracking();
      check_resolution();
      check_boxes();
      check_stiffness();
      check_combination();
      check_inertia();
    }
    return std::move(warnings_);
  }

 private:
  template <class... Args>
  [[noreturn]] void refuse(std::string_view name, fmt::format_string<Args...> format, Args&&... args) const {
    throw Error(Exit::bad_input, said(name) + fmt::format(format, std::forward<Args>(args)...));
  }
  template <class... Args>
  void warn(std::string_view name, fmt::format_string<Args...> format, Args&&... args) {
    warnings_.push_back(said(name) + fmt::format(format, std::forward<Args>(args)...));
  }
  [[nodiscard]] std::string said(std::string_view name) const {
    return fmt::format("{}: {} = {} ", run_.where(name), name, run_.value(name).value);
  }
  // The time step at which a number proportional to it would be at its limit, as advice.
  [[nodiscard]] std::string slower(double number, double limit) const {
    return fmt::format("Lower numerics.time_step_us to {:.4g} or less", units_.dt_us() * limit / number);
  }

  void check_flow() {
    const bool has_walls = !lattice_.lattice.periodic[1] || !lattice_.lattice.periodic[2];
    const auto& flow = p_.flow;
    if ((flow.driving == Driving::mean_velocity || flow.driving == Driving::pressure_gradient) && !has_walls)
      refuse("flow.driving",
             "accelerates a box without walls for ever. Choose boundary_y or boundary_z = wall, or for plug "
             "flow driving = rest with initial = uniform");
    if (flow.driving == Driving::shear && lattice_.lattice.periodic[2])
      refuse("flow.driving", "moves the z walls, but boundary_z = periodic. Choose boundary_z = wall");
    if (flow.initial == InitialFlow::uniform && has_walls)
      refuse("flow.initial",
             "is plug flow, which walls forbid. Choose initial = developed, or boundary_y and boundary_z = periodic");
    if (flow.initial == InitialFlow::developed && flow.driving == Driving::rest)
      refuse("flow.initial", "needs a driving, but driving = rest. Choose initial = rest");
    if (flow.driving == Driving::shear && !lattice_.lattice.periodic[1]) {
      if (flow.initial == InitialFlow::developed)
        refuse("flow.initial",
               "is known for shear between z walls alone. Choose boundary_y = periodic, or initial = rest");
      warn("flow.driving", "between standing y walls gives no uniform shear rate. Choose boundary_y = periodic");
    }
  }

  void check_relaxation_times() {
    constexpr double lowest = 0.505, highest = 50;
    for (const auto& [fluid, tau] : {std::pair{"plasma", lattice_.tau_out}, std::pair{"the cell", lattice_.tau_in}}) {
      const auto name = run_.value("fluid.lambda").given ? "fluid.lambda" : "numerics.tau_plasma";
      if (tau < lowest)
        refuse(name,
               "gives tau = {:.4g} in {}; at least {} is needed. Raise numerics.tau_plasma and with it time_step_us",
               tau, fluid, lowest);
      if (tau > highest)
        refuse(name, "gives tau = {:.4g} in {}; at most {} works. Lower numerics.tau_plasma to {:.4g} or less", tau,
               fluid, highest, 0.5 + (highest - 0.5) / p_.fluid.lambda);
    }
    if (p_.numerics.tau_plasma < 0.6 || p_.numerics.tau_plasma > 2)
      warn("numerics.tau_plasma",
           "is outside the usual window, 0.6 to 2. Check one point at another tau and time step");
  }

  void check_mach() {
    if (n_.mach > p_.bounds.max_mach * (1 + slack))
      refuse("numerics.time_step_us", "gives Mach number {:.3g} at {:.4g} mm/s; bounds.max_mach = {} is the limit. {}",
             n_.mach, units_.speed_mm_per_s(lattice_.max_velocity), canonical(p_.bounds.max_mach),
             slower(n_.mach, p_.bounds.max_mach));
  }

  void check_collision() {
    constexpr double noticeable = 5e-3;
    const bool is_mrt = p_.numerics.collision == CollisionLaw::mrt;
    if (std::abs(n_.wall_error) > noticeable)
      warn(
          is_mrt ? "numerics.collision" : "numerics.magic_lambda",
          "misplaces the walls: the largest velocity is off by {:+.2g} %. Use collision = trt with magic_lambda = 3/16",
          100 * n_.wall_error);
    if (is_mrt && lattice_.tau_in > 8)
      warn("numerics.collision",
           "with tau = {:.3g} inside the cell is inaccurate at the membrane. Use collision = trt, or lower "
           "numerics.tau_plasma to {:.3g}",
           lattice_.tau_in, 0.5 + 7.5 / p_.fluid.lambda);
  }

  void check_snapshots() {
    const OutputParameters& o = p_.output;
    for (const auto& [name, interval_s] : {std::pair{"output.snapshot_interval_s", o.snapshot_interval_s},
                                           std::pair{"output.cell_snapshot_interval_s", o.cell_snapshot_interval_s}})
      if (interval_s > 0 && interval_s * 1e6 < units_.dt_us() * (1 - slack))
        refuse(name, "is shorter than a time step, {:.4g} s. Raise it, or take 0 for none", units_.dt_us() * 1e-6);
    const int shortest = std::min({lattice_.lattice.size[0], lattice_.lattice.size[1], lattice_.lattice.size[2]});
    if (o.snapshot_interval_s > 0 && o.snapshot_stride >= shortest)
      refuse("output.snapshot_stride", "leaves one node of {} along an axis; at most {} leaves two", shortest,
             shortest - 1);
  }

  void check_tracking() {
    if (p_.numerics.tracking == TrackingChoice::off) {
      if (p_.fluid.lambda != 1)
        refuse("numerics.tracking",
               "leaves the inside fluid where the cell began; with lambda = {} it must move. Choose "
               "tracking = vertex_normals, or lambda = 1",
               canonical(p_.fluid.lambda));
      return;
    }
    if (p_.numerics.correction_interval == 0 && p_.fluid.lambda != 1)
      warn("numerics.correction_interval", "leaves wrong inside flags for ever. Set it to some hundred steps");
  }

  void check_resolution() {
    constexpr double fewest = 6, most_excess = 0.03;
    for (const CellPlacement& cell : lattice_.cells) {
      const double radius = std::max(cell.radius, cell.semi_axes.maxCoeff());
      if (radius == 0) continue;  // a mesh: checked once it is read
      if (radius < fewest * (1 - slack))
        refuse("numerics.node_spacing_um",
               "gives {:.3g} nodes per radius; at least {} are needed. Lower it to {:.4g} or less", radius, fewest,
               units_.dx_um() * radius / fewest);
    }
    const double radius = lattice_.cells[0].radius;
    const bool in_channel = p_.cells[0].shape == Shape::red_blood_cell && lattice_.body_force > 0;
    const double excess = hydrodynamic_excess(p_.numerics.kernel) / radius;
    if (in_channel && excess > most_excess * (1 + slack))
      warn("numerics.node_spacing_um",
           "lets the membrane act {:.2g} um thicker than it is with this kernel, {:.2g} radii: above {} cells come to "
           "the axis the sooner the thicker it acts (studies/lambda-transition). Lower it to {:.4g} or less, or choose "
           "a narrower numerics.kernel, before quoting a transition",
           excess * radius * units_.dx_um(), excess, most_excess, units_.dx_um() * most_excess / excess);
  }

  void check_boxes() {
    for (std::size_t c = 0; c < lattice_.cells.size(); ++c) {
      const CellPlacement& cell = lattice_.cells[c];
      if (cell.half_extent.isZero()) continue;  // a mesh
      const auto found = check_box(run_, lattice_, c, cell.centre - cell.half_extent, cell.centre + cell.half_extent);
      warnings_.insert(warnings_.end(), found.begin(), found.end());
    }
  }

  void check_stiffness() {
    const std::string_view modulus = n_.area_number > n_.shear_number ? "kappa_A" : "kappa_S";
    const double stiffest = std::max(n_.area_number, n_.shear_number);
    if (stiffest > n_.area_limit)
      refuse("numerics.time_step_us", "gives {} dt/(mu dx) = {:.3g}; above {} the membrane is unstable. {}", modulus,
             stiffest, n_.area_limit, slower(stiffest, n_.area_limit));
    if (n_.bending_number > n_.bending_limit)
      refuse("numerics.time_step_us", "gives kappa_B dt/(mu dx^3) = {:.3g}; above {} the membrane is unstable. {}",
             n_.bending_number, n_.bending_limit, slower(n_.bending_number, n_.bending_limit));
  }

  /// Skalak's tension falls again in a triangle that is compressed far enough; a soft area comes to that in the paper's
  /// flow, at any time step.
  void check_soft_area(const TrialRuns& trials) {
    const bool was_tried =
        p_.membrane.law == InPlaneLaw::skalak && p_.cells[0].shape == Shape::red_blood_cell && lattice_.body_force > 0;
    if (!was_tried || p_.membrane.area_ratio >= held_area_ratio) return;
    if (p_.membrane.area_ratio > trials.lost_area_ratio) {
      warn("membrane.area_ratio",
           "may lose the cell: at C = 10 some trial runs with this kernel ended with folded or collapsed triangles, "
           "after 5 to 160 ms (studies/safe-combinations). {} held",
           held_area_ratio);
      return;
    }
    const std::string text = fmt::format(
        "loses the cell with kernel = {}: at C = {} and below all trial runs were lost within 50 ms "
        "(studies/safe-combinations). "
        "{} held; so did 10 for 0.05 s and more with kernel = 2-point and advection = averaged",
        run_.value("numerics.kernel").value, trials.lost_area_ratio, held_area_ratio);
    if (p_.bounds.unsafe_combination == UnsafeCombination::refuse)
      refuse("membrane.area_ratio", "{}; or run it all the same with bounds.unsafe_combination = run", text);
    warn("membrane.area_ratio", "{}", text);
  }

  void check_combination() {
    const TrialRuns trials = trial_runs(p_.numerics.kernel, p_.numerics.advection);
    check_soft_area(trials);
    const double held = trials.held, lost = trials.lost;
    const double stiffness = std::max(lattice_.moduli.kappa_A, lattice_.moduli.kappa_S);
    if (stiffness <= held) return;
    const bool was_lost = lattice_.moduli.kappa_A >= lost;  // the trials were of stiff areas, not of stiff shear
    std::string remedy = choices_that_held(stiffness);
    // With a step shorter by s, and tau - 1/2 with it, the Reynolds number stays and the stiffness falls by s^2.
    if (held > 0)
      remedy += fmt::format("{}time_step_us and tau_plasma - 1/2 smaller by {:.3g}", remedy.empty() ? "" : ", or ",
                            std::sqrt(stiffness / held));
    const std::string text = fmt::format(
        "with advection = {} {} a membrane of stiffness kappa_A dt^2/(rho dx^3) = {:.3g}: trial runs {}, and were lost "
        "from {:.3g} on (studies/safe-combinations). Choose {}",
        run_.value("numerics.advection").value, was_lost ? "loses" : "may lose", stiffness,
        held > 0 ? fmt::format("held up to {:.3g}", held) : "held at no stiffness", lost, remedy);
    if (was_lost && p_.bounds.unsafe_combination == UnsafeCombination::refuse)
      refuse("numerics.kernel", "{}; or run it all the same with bounds.unsafe_combination = run", text);
    warn("numerics.kernel", "{}", text);
  }

  void check_inertia() {
    constexpr double inertial = 0.3;
    const double reynolds = n_.reynolds_cell * n_.inflation;
    if (reynolds > inertial * (1 + slack))
      warn("numerics.time_step_us",
           "inflates the Reynolds number {:.3g} times, to {:.3g} for the cell; above {} inertia moves it "
           "across the flow. {}, or raise numerics.tau_plasma",
           n_.inflation, reynolds, inertial, slower(reynolds, inertial));
  }

  const RunFile& run_;
  const RunParameters& p_;
  const LatticeParameters& lattice_;
  const Units& units_;
  const DimensionlessNumbers n_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> check_feasibility(const RunFile& run, const LatticeParameters& lattice, const Units& units) {
  return Examination(run, lattice, units).warnings();
}

}  // namespace rouleau
