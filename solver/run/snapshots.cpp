// SPDX-License-Identifier: BSD-3-Clause
#include "run/snapshots.hpp"

#include "base/thinning.hpp"
#include "membrane/local_state.hpp"

namespace rouleau {

namespace {

std::vector<float> scaled(const std::vector<float>& values, double factor) {
  std::vector<float> all;
  all.reserve(values.size());
  for (const float v : values) all.push_back(static_cast<float>(v * factor));
  return all;
}

std::vector<float> scaled(const std::vector<double>& values, double factor) {
  std::vector<float> all;
  all.reserve(values.size());
  for (const double v : values) all.push_back(static_cast<float>(v * factor));
  return all;
}

double in_steps(double interval_s, const Units& units) { return interval_s * 1e6 / units.dt_us(); }

}  // namespace

SnapshotPlan::SnapshotPlan(const Setup& setup)
    : fields(in_steps(setup.run.parameters.output.snapshot_interval_s, setup.units)),
      cells(in_steps(setup.run.parameters.output.cell_snapshot_interval_s, setup.units)),
      has_cells(!setup.run.parameters.cells.empty()) {}

std::int64_t SnapshotPlan::cell_count(std::int64_t last) const {
  if (!has_cells) return 0;
  std::int64_t both = 0;
  for (std::int64_t n = 0; n < fields.count(last); ++n) both += cells.is_due(fields.step_of(n)) ? 1 : 0;
  return fields.count(last) + cells.count(last) - both;
}

std::int64_t snapshot_bytes(const Setup& setup) {
  const SnapshotPlan plan(setup);
  const Int3 size = thinned(setup.lattice.lattice.size, setup.run.parameters.output.snapshot_stride);
  // Measured: see share/contract.md section 13. The force is zero but near membranes, flags are long runs.
  constexpr double fields_compressed = 0.48, cells_compressed = 0.56;
  constexpr double file_overhead = 6144, series_entry = 1400;
  const double fields = fields_compressed * static_cast<double>(uncompressed_field_bytes(size));
  const double cells = cells_compressed *
                       static_cast<double>(uncompressed_cell_bytes(static_cast<std::uint64_t>(setup.cells.vertices()),
                                                                   static_cast<std::uint64_t>(setup.cells.triangles()),
                                                                   setup.cells.starts.size()));
  const std::int64_t last = setup.lattice.steps;
  return static_cast<std::int64_t>(static_cast<double>(plan.field_count(last)) *
                                       (fields + file_overhead + series_entry) +
                                   static_cast<double>(plan.cell_count(last)) * (cells + file_overhead + series_entry));
}

Snapshots::Snapshots(const Setup& setup, const Communicator& comm, FileSystem& files,
                     const std::filesystem::path& run_directory, const Attempt* attempt)
    : setup_(setup),
      comm_(comm),
      files_(files),
      directory_(run_directory / "snapshots"),
      attempt_(attempt),
      plan_(setup) {}

SnapshotPlace Snapshots::place() const {
  return {files_, directory_, [this] { attempt_->fence(); }, attempt_->number()};
}

void Snapshots::take(Simulation& simulation) {
  const std::int64_t step = simulation.steps_done();
  const bool fields = plan_.fields_are_due(step), cells = plan_.cells_are_due(step);
  if (!fields && !cells) return;
  simulation.check_health();
  simulation.find_membrane_forces();
  LatticePicture picture;
  if (fields) picture = simulation.take_picture(setup_.run.parameters.output.snapshot_stride);
  comm_.on_root([&] {
    if (fields) {
      write_snapshot(place(), field_snapshot(picture, step));
      field_series_.write(place(), snapshot_name(SnapshotKind::fields, step));
    }
    if (cells) {
      write_snapshot(place(), cell_snapshot(simulation.cells(), step));
      cell_series_.write(place(), snapshot_name(SnapshotKind::cells, step));
    }
  });
}

SnapshotMoment Snapshots::moment(std::int64_t step) const {
  SnapshotMoment moment;
  moment.step = step;
  moment.time_s = setup_.units.time_s(step);
  for (std::size_t axis = 0; axis < 3; ++axis)
    moment.box_um[axis] = setup_.units.length_um(setup_.lattice.lattice.size[axis]);
  moment.node_spacing_um = setup_.units.dx_um();
  return moment;
}

FieldSnapshot Snapshots::field_snapshot(const LatticePicture& picture, std::int64_t step) const {
  const Units& units = setup_.units;
  FieldSnapshot s;
  s.moment = moment(step);
  s.stride = setup_.run.parameters.output.snapshot_stride;
  s.size = picture.size;
  s.velocity_mm_per_s = scaled(picture.velocity, units.speed_mm_per_s(1));
  s.pressure_Pa = scaled(picture.rho_1, units.pressure_Pa(1.0 / 3));  // p = c_s^2 rho
  s.inside = picture.inside;
  s.membrane_force_pN_per_um3 = scaled(picture.force, units.force_density_pN_per_um3(1));
  return s;
}

CellSnapshot Snapshots::cell_snapshot(const Cells& cells, std::int64_t step) const {
  const Units& units = setup_.units;
  CellSnapshot s;
  s.moment = moment(step);
  for (std::size_t v = 0; v < cells.vertices(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      s.vertices_um.push_back(static_cast<float>(units.coordinate_um(at(cells.X, v)[axis])));
      s.force_pN.push_back(static_cast<float>(units.force_pN(at(cells.F, v)[axis])));
    }
  const LocalState state = local_state(cells, setup_.lattice.moduli);
  s.tension_uN_per_m = scaled(state.tension, units.tension_uN_per_m(1));
  s.area_strain = scaled(state.area_strain, 1);
  s.mean_curvature_per_um = scaled(state.mean_curvature, units.curvature_per_um(1));
  for (std::size_t t = 0; t < cells.triangles.size(); ++t)
    s.triangles.insert(s.triangles.end(), {cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]});
  s.cell.resize(cells.triangles.size());
  for (std::size_t c = 0; c < cells.ranges.size(); ++c) {
    const CellRange& r = cells.ranges[c];
    std::fill(s.cell.begin() + r.triangle_begin, s.cell.begin() + r.triangle_end, static_cast<std::int32_t>(c));
    s.cell_ranges.insert(s.cell_ranges.end(), {r.vertex_begin, r.vertex_end, r.triangle_begin, r.triangle_end});
    s.cell_periods.insert(s.cell_periods.end(), cells.images[c].begin(), cells.images[c].end());
  }
  return s;
}

}  // namespace rouleau
