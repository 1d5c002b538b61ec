// SPDX-License-Identifier: BSD-3-Clause
#include "run/conversion_table.hpp"

#include <fmt/format.h>

namespace rouleau {
namespace {

std::string line(std::string_view what, std::string_view physical, std::string_view lattice) {
  return fmt::format("  {:<38} {:>22}{}{}\n", what, physical, lattice.empty() ? "" : "   ", lattice);
}
std::string quantity(std::string_view what, double value, std::string_view unit, double lattice) {
  return line(what, fmt::format("{:.6g} {}", value, unit), fmt::format("{:.6g}", lattice));
}
std::string number(std::string_view what, double value, std::string_view note = "") {
  return line(what, fmt::format("{:.4g}", value), note);
}

std::string flow_lines(const RunParameters& p, const LatticeParameters& lattice, const Units& units) {
  std::string text;
  if (lattice.mean_velocity > 0)
    text += quantity("mean velocity, held", p.flow.mean_velocity_mm_per_s, "mm/s", lattice.mean_velocity);
  if (lattice.body_force > 0)
    text += quantity(lattice.mean_velocity > 0 ? "pressure gradient of the empty channel" : "pressure gradient, fixed",
                     units.pressure_gradient_Pa_per_m(lattice.body_force), "Pa/m", lattice.body_force);
  if (lattice.wall_velocity > 0) {
    text += quantity("shear rate", p.flow.shear_rate_per_s, "1/s", units.rate(p.flow.shear_rate_per_s));
    text += quantity("velocity of the z walls, +-", units.speed_mm_per_s(lattice.wall_velocity), "mm/s",
                     lattice.wall_velocity);
  }
  if (lattice.max_velocity > 0)
    text +=
        quantity("largest velocity expected", units.speed_mm_per_s(lattice.max_velocity), "mm/s", lattice.max_velocity);
  return text;
}

std::string stretch_lines(const LatticeParameters& lattice, const Units& units, const std::vector<MeshFacts>& meshes) {
  const StretchForce& stretch = lattice.stretch;
  std::string text = quantity(fmt::format("force on each end along {}", "xyz"[*stretch.axis]),
                              units.force_pN(stretch.force), "pN", stretch.force);
  for (std::size_t c = 0; c < meshes.size(); ++c)
    for (const auto& [end, vertices] : {std::pair("low", meshes[c].pulled[0]), std::pair("high", meshes[c].pulled[1])})
      text += quantity(fmt::format("  cell {}, {} end: {} vertices, each", c, end, vertices),
                       units.force_pN(stretch.force) / static_cast<double>(vertices), "pN",
                       stretch.force / static_cast<double>(vertices));
  return text;
}

std::string membrane_lines(const LatticeParameters& lattice, const Units& units, const DimensionlessNumbers& n) {
  const Moduli& m = lattice.moduli;
  std::string text;
  text += quantity("shear modulus kappa_S", units.tension_uN_per_m(m.kappa_S), "uN/m", m.kappa_S);
  text += quantity("  the same as G_s = kappa_S / 3", units.tension_uN_per_m(m.kappa_S / 3), "uN/m", m.kappa_S / 3);
  if (m.law == InPlaneLaw::skalak)
    text += quantity("area modulus kappa_A = C kappa_S", units.tension_uN_per_m(m.kappa_A), "uN/m", m.kappa_A);
  else
    text += quantity("neo-Hookean; area modulus 3 G_s", units.tension_uN_per_m(m.kappa_S), "uN/m", m.kappa_S);
  text += quantity("bending modulus kappa_B", units.energy_joule(m.kappa_B), "J", m.kappa_B);
  text += number("capillary number mu u_max / kappa_S", n.capillary_flow);
  text += number("capillary number mu gamma R / G_s", n.capillary_shear);
  if (m.law == InPlaneLaw::skalak)
    text += number("kappa_A dt / (mu dx)", n.area_number, fmt::format("limit {}", n.area_limit));
  text += number("kappa_B dt / (mu dx^3)", n.bending_number, fmt::format("limit {}", n.bending_limit));
  return text;
}

}  // namespace

std::string conversion_table(const RunFile& run, const LatticeParameters& lattice, const Units& units,
                             const std::vector<MeshFacts>& meshes) {
  const RunParameters& p = run.parameters;
  const DimensionlessNumbers n = dimensionless_numbers(run, lattice, units);
  const auto& size = lattice.lattice.size;
  std::string text = line("", "physical", "lattice");
  text += quantity("node spacing dx", units.dx_um(), "um", 1);
  text += quantity("time step dt", units.dt_us(), "us", 1);
  text += line(
      "channel",
      fmt::format("{:.4g} x {:.4g} x {:.4g} um", p.channel.length_x_um, p.channel.length_y_um, p.channel.length_z_um),
      fmt::format("{} x {} x {} = {} nodes", size[0], size[1], size[2], lattice.lattice.nodes()));
  text += quantity("plasma viscosity; tau", p.fluid.plasma_viscosity_mPa_s, "mPa s", lattice.tau_out);
  if (!lattice.cells.empty())
    text += quantity("viscosity inside the cell; tau", p.fluid.plasma_viscosity_mPa_s * p.fluid.lambda, "mPa s",
                     lattice.tau_in);
  text += quantity("density that the lattice stands for", units.effective_density_kg_per_m3(), "kg/m3", 1);
  text += flow_lines(p, lattice, units);
  text += number("Mach number", n.mach, fmt::format("limit {:.4g}", p.bounds.max_mach));
  text += number("inflation of the Reynolds number", n.inflation);
  if (n.reynolds_channel > 0)
    text += line("Reynolds number of the channel", fmt::format("{:.4g}", n.reynolds_channel),
                 fmt::format("{:.4g}", n.reynolds_channel * n.inflation));
  if (n.reynolds_cell > 0)
    text += line("Reynolds number of the cell", fmt::format("{:.4g}", n.reynolds_cell),
                 fmt::format("{:.4g}", n.reynolds_cell * n.inflation));
  if (!lattice.cells.empty()) text += membrane_lines(lattice, units, n);
  for (std::size_t c = 0; c < meshes.size(); ++c) {
    const MeshFacts& m = meshes[c];
    text += line(fmt::format("edges of cell {}: mean (min, max)", c),
                 fmt::format("{:.3g} ({:.3g}, {:.3g}) um", units.length_um(m.edge_mean), units.length_um(m.edge_min),
                             units.length_um(m.edge_max)),
                 fmt::format("{:.3g} ({:.3g}, {:.3g})", m.edge_mean, m.edge_min, m.edge_max));
  }
  if (lattice.stretch.axis) text += stretch_lines(lattice, units, meshes);
  text += line("end time", fmt::format("{:.6g} s", p.time.end_time_s), fmt::format("{} steps", lattice.steps));
  return text;
}

}  // namespace rouleau
