// SPDX-License-Identifier: BSD-3-Clause
// The part of the feasibility checks that looks at one placed cell.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/feasibility.hpp"
#include "run/value_text.hpp"

namespace rouleau {
namespace {

constexpr std::array<char, 3> axis_name{'x', 'y', 'z'};

// Half the width of the kernel's support, node spacings.
double kernel_reach(KernelWidth kernel) {
  switch (kernel) {
    case KernelWidth::two_point:
      return 1.0;
    case KernelWidth::three_point:
      return 1.5;
    case KernelWidth::four_point:
      return 2.0;
  }
  return 2.0;
}

std::string parameter_of(std::size_t cell, std::string_view name) {
  return cell == 0 ? fmt::format("cell.{}", name) : fmt::format("cell.{}.{}", cell + 1, name);
}

// The place in the run file that decides where the cell stands along an axis.
std::string where_of(const RunFile& run, std::size_t cell, int axis) {
  constexpr std::array<std::string_view, 3> names{"position_x_um", "offset_y_um", "offset_z_um"};
  const std::string name = parameter_of(cell, names[static_cast<std::size_t>(axis)]);
  return fmt::format("{}: {} = {}", run.where(name), name, run.value(name).value);
}

void refuse_too_big(const RunFile& run, const LatticeParameters& lattice, std::size_t cell, int axis, double extent) {
  const double dx_um = run.parameters.numerics.node_spacing_um;
  const double room = lattice.lattice.size[axis];
  const double needed =
      lattice.lattice.periodic[axis] ? extent + 2 * kernel_reach(run.parameters.numerics.kernel) : extent;
  if (needed <= room + 1e-9) return;
  const std::string length = fmt::format("channel.length_{}_um", axis_name[static_cast<std::size_t>(axis)]);
  fail(Exit::bad_input,
       "{}: {} = {} is too short for cell {}, which needs {:.4g} um there{}. Lengthen the channel or turn the cell",
       run.where(length), length, run.value(length).value, cell, needed * dx_um,
       lattice.lattice.periodic[axis] ? ", the kernel's reach to its own image included" : "");
}

}  // namespace

std::vector<std::string> check_box(const RunFile& run, const LatticeParameters& lattice, std::size_t cell,
                                   const Vec3& lower, const Vec3& upper) {
  std::vector<std::string> warnings;
  const double dx_um = run.parameters.numerics.node_spacing_um;
  const double reach = kernel_reach(run.parameters.numerics.kernel);
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = upper[axis] - lower[axis], room = lattice.lattice.size[axis];
    refuse_too_big(run, lattice, cell, axis, extent);
    if (lattice.lattice.periodic[axis]) {
      const double gap = room - extent;
      if (axis == 0 && lattice.body_force > 0 && gap < extent)
        warnings.push_back(
            fmt::format("{}: channel.length_x_um leaves {:.3g} um between cell {} and its own periodic image; they "
                        "interact below the cell's length. Lengthen the channel, or check one point in a longer one",
                        run.where("channel.length_x_um"), gap * dx_um, cell));
      continue;
    }
    // Half-way walls stand at -1/2 and N - 1/2.
    const double clearance = std::min(lower[axis] + 0.5, room - 0.5 - upper[axis]);
    const char name = axis_name[static_cast<std::size_t>(axis)];
    if (clearance < -1e-9)
      fail(Exit::bad_input, "{} puts cell {} {:.4g} um into a {} wall. Move it towards the axis by that much",
           where_of(run, cell, axis), cell, -clearance * dx_um, name);
    if (clearance < reach)
      warnings.push_back(fmt::format(
          "{} leaves {:.3g} node spacings between cell {} and a {} wall, less than the kernel's reach of {}: "
          "the wall rule acts from the start. Move the cell inwards or lower node_spacing_um",
          where_of(run, cell, axis), clearance, cell, name, reach));
  }
  return warnings;
}

std::vector<std::string> check_mesh_feasibility(const RunFile& run, const LatticeParameters& lattice, std::size_t cell,
                                                const MeshFacts& mesh) {
  constexpr double longest_edge = 2, finest_mean = 0.4, coarsest_mean = 1.2, fewest_per_radius = 6;
  const RunParameters& p = run.parameters;
  const Shape shape = p.cells.at(cell).shape;
  const bool is_loaded = shape == Shape::mesh || shape == Shape::checkpoint;
  const bool is_by_frequency = !is_loaded && run.value(parameter_of(cell, "frequency")).given;
  const std::string name =
      parameter_of(cell, is_loaded ? "mesh_file" : (is_by_frequency ? "frequency" : "subdivisions"));
  const std::string said = fmt::format("{}: {} = {} ", run.where(name), name, run.value(name).value);
  std::vector<std::string> warnings;
  if (is_loaded) {
    const double radius = 0.5 * (mesh.upper - mesh.lower).maxCoeff();
    if (radius < fewest_per_radius * (1 - 1e-9))
      fail(Exit::bad_input,
           "{}is {:.3g} nodes in radius; at least {} are needed. Lower numerics.node_spacing_um, or check {} (a mesh "
           "file is in um)",
           said, radius, fewest_per_radius, parameter_of(cell, "scale"));
    warnings = check_box(run, lattice, cell, mesh.lower, mesh.upper);
  }
  if (mesh.edge_max > longest_edge)
    fail(Exit::bad_input,
         "{}has edges up to {:.3g} node spacings (mean {:.3g}); above {} the inside flags leak. Refine the mesh, or "
         "raise numerics.node_spacing_um to {:.4g} or more",
         said, mesh.edge_max, mesh.edge_mean, longest_edge, p.numerics.node_spacing_um * mesh.edge_max / longest_edge);
  if (mesh.edge_mean < finest_mean || mesh.edge_mean > coarsest_mean)
    warnings.push_back(fmt::format("{}has a mean edge of {:.3g} node spacings, outside {} to {}. {}", said,
                                   mesh.edge_mean, finest_mean, coarsest_mean,
                                   mesh.edge_mean < finest_mean ? "Coarsen the mesh" : "Refine the mesh"));
  return warnings;
}

}  // namespace rouleau
