// SPDX-License-Identifier: BSD-3-Clause
#include "run/cell_setup.hpp"

#include <Eigen/Geometry>

#include "base/error.hpp"
#include "membrane/check_surface.hpp"
#include "membrane/edges.hpp"
#include "membrane/shapes.hpp"
#include "membrane/stretch.hpp"
#include "membrane/surface_file.hpp"
#include "membrane/transform.hpp"
#include "storage/inspect.hpp"

namespace rouleau {

namespace {

/// Centre of the enclosed volume of a surface that stands alone.
Vec3 centre_of_volume(const Surface& surface) {
  Vec3 moment = Vec3::Zero();
  double six_volumes = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3 a = at(surface.X, static_cast<std::size_t>(surface.triangles.a[t]));
    const Vec3 b = at(surface.X, static_cast<std::size_t>(surface.triangles.b[t]));
    const Vec3 c = at(surface.X, static_cast<std::size_t>(surface.triangles.c[t]));
    const double part = a.dot(b.cross(c));
    six_volumes += part;
    moment += part * (a + b + c) / 4;
  }
  return moment / six_volumes;
}

/// Where the checkpoint has its cell across the channel.   returns um from the axis, (0, y, z)
Vec3 saved_place_um(const CellParameters& cell, FileSystem& files) {
  const SavedCell saved = read_cell(files, cell.mesh_file, cell.mesh_cell);
  const Vec3 centre = centre_of_volume(saved.surface);
  return saved.node_spacing_um *
         Vec3(0, centre.y() - 0.5 * (saved.lattice[1] - 1), centre.z() - 0.5 * (saved.lattice[2] - 1));
}

/// A surface in um from a file, or one cell of a checkpoint with the stress-free shape it had there.
CellStart read_start(const CellParameters& cell, FileSystem& files) {
  if (cell.shape == Shape::mesh) {
    CellStart start{read_surface(cell.mesh_file), std::nullopt};
    check_surface(start.shape, cell.mesh_file.string());
    return start;
  }
  SavedCell saved = read_cell(files, cell.mesh_file, cell.mesh_cell);
  CellStart start{saved.surface, Surface{saved.X_reference, saved.surface.triangles}};
  scale(start.shape, saved.node_spacing_um);
  scale(*start.reference, saved.node_spacing_um);
  check_surface(start.shape, cell.mesh_file.string());
  return start;
}

/// The cell about the origin, in lattice units, not yet turned.
CellStart make_start(const CellParameters& cell, const CellPlacement& placement, FileSystem& files) {
  switch (cell.shape) {
    case Shape::red_blood_cell:
      return {red_blood_cell(Division::of_frequency(cell.frequency), placement.radius), std::nullopt};
    case Shape::sphere:
      return {sphere(Division::of_frequency(cell.frequency), placement.radius), std::nullopt};
    case Shape::ellipsoid:
      return {ellipsoid(Division::of_frequency(cell.frequency), placement.semi_axes), std::nullopt};
    case Shape::mesh:
    case Shape::checkpoint:
      break;
    case Shape::none:
      throw std::logic_error("a cell without a shape");
  }
  CellStart start = read_start(cell, files);
  scale(start.shape, placement.from_um);
  if (start.reference) scale(*start.reference, placement.from_um);
  translate(start.shape, -centre_of_volume(start.shape));
  return start;
}

void use_reference_file(const CellParameters& cell, double from_um, CellStart& start) {
  start.reference = read_surface(cell.reference_file);
  check_surface(*start.reference, cell.reference_file.string());
  scale(*start.reference, from_um);
}

MeshFacts facts_of(const Surface& surface) {
  MeshFacts facts;
  const EdgeLengths edges = edge_lengths(surface);
  facts.edge_min = edges.min;
  facts.edge_mean = edges.mean;
  facts.edge_max = edges.max;
  facts.lower = facts.upper = at(surface.X, 0);
  for (std::size_t v = 1; v < surface.X.size(); ++v) {
    facts.lower = facts.lower.cwiseMin(at(surface.X, v));
    facts.upper = facts.upper.cwiseMax(at(surface.X, v));
  }
  return facts;
}

std::array<std::size_t, 2> pulled_vertices(const Surface& shape, const StretchForce& stretch) {
  const auto vertices = static_cast<std::int32_t>(shape.X.size());
  const auto [low, high] = end_vertices(shape.X, 0, vertices, *stretch.axis, stretch.share);
  return {low.size(), high.size()};
}

Body body_of(const CellParameters& cell, const CellPlacement& placement) {
  Body body;
  body.centre = placement.centre;
  body.rotation = Eigen::AngleAxisd(placement.rotation_angle, placement.rotation_axis).toRotationMatrix();
  body.radii = cell.shape == Shape::ellipsoid ? placement.semi_axes : Vec3::Constant(placement.radius);
  body.shape = cell.shape == Shape::red_blood_cell ? Body::Shape::red_blood_cell : Body::Shape::ellipsoid;
  return body;
}

bool has_equation(const CellParameters& cell) { return cell.shape != Shape::mesh && cell.shape != Shape::checkpoint; }

}  // namespace

std::int64_t CellSetup::vertices() const {
  std::int64_t n = 0;
  for (const auto& start : starts) n += static_cast<std::int64_t>(start.shape.X.size());
  return n;
}

std::int64_t CellSetup::triangles() const {
  std::int64_t n = 0;
  for (const auto& start : starts) n += static_cast<std::int64_t>(start.shape.triangles.size());
  return n;
}

CellSetup set_up_cells(const RunFile& run, const LatticeParameters& lattice, FileSystem& files) {
  CellSetup setup;
  bool all_have_equations = true;
  const auto& cells = run.parameters.cells;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const CellPlacement& placement = lattice.cells[n];
    CellStart start = make_start(cells[n], placement, files);
    if (cells[n].reference == Reference::file) use_reference_file(cells[n], placement.from_um, start);
    rotate(start.shape, placement.rotation_axis, placement.rotation_angle);
    translate(start.shape, placement.centre);
    if (cells[n].offset_from == OffsetFrom::checkpoint)
      translate(start.shape, saved_place_um(cells[n], files) * placement.from_um / cells[n].scale);

    MeshFacts facts = facts_of(start.shape);
    if (lattice.stretch.axis) facts.pulled = pulled_vertices(start.shape, lattice.stretch);
    for (auto& warning : check_mesh_feasibility(run, lattice, n, facts)) setup.warnings.push_back(std::move(warning));
    setup.meshes.push_back(facts);
    setup.starts.push_back(std::move(start));
    all_have_equations = all_have_equations && has_equation(cells[n]);
    if (has_equation(cells[n])) setup.bodies.push_back(body_of(cells[n], placement));
  }
  if (!all_have_equations) setup.bodies.clear();
  const Cells assembled = assemble(setup.starts);
  for (std::size_t n = 0; n < cells.size(); ++n) setup.markers.push_back(choose_markers(assembled, n));
  return setup;
}

}  // namespace rouleau
