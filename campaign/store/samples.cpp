// SPDX-License-Identifier: BSD-3-Clause
// Samples, and how far the log they come from was read.
#include "store/store.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

SampleRow sample_in(const Statement& statement) {
  SampleRow sample;
  sample.step = statement.integer(0);
  sample.cell = static_cast<int>(statement.integer(1));
  sample.time_s = statement.real(2);
  sample.d_um = statement.optional_real(3);
  sample.x_um = statement.optional_real(4);
  sample.y_um = statement.optional_real(5);
  sample.z_um = statement.optional_real(6);
  sample.asphericity = statement.optional_real(7);
  sample.volume_ratio = statement.optional_real(8);
  sample.area_ratio = statement.optional_real(9);
  sample.inclination_deg = statement.optional_real(10);
  sample.inside_nodes = statement.optional_integer(11);
  sample.inside_ratio = statement.optional_real(12);
  sample.flips = statement.optional_integer(13);
  sample.mean_velocity_mm_per_s = statement.optional_real(14);
  sample.pressure_gradient_Pa_per_m = statement.optional_real(15);
  sample.velocity_x_mm_per_s = statement.optional_real(16);
  sample.taylor_deformation = statement.optional_real(17);
  sample.angle_xz_deg = statement.optional_real(18);
  sample.angle_xy_deg = statement.optional_real(19);
  sample.extent_x_um = statement.optional_real(20);
  sample.extent_y_um = statement.optional_real(21);
  sample.extent_z_um = statement.optional_real(22);
  sample.marker_y_dx_um = statement.optional_real(23);
  sample.marker_y_dy_um = statement.optional_real(24);
  sample.marker_y_dz_um = statement.optional_real(25);
  sample.marker_z_dx_um = statement.optional_real(26);
  sample.marker_z_dy_um = statement.optional_real(27);
  sample.marker_z_dz_um = statement.optional_real(28);
  sample.finite = statement.integer(29) != 0;
  return sample;
}

}  // namespace

std::vector<SampleRow> Store::samples(std::string_view point) const {
  Statement statement = database_.prepare(
      "SELECT step, cell, time_s, d_um, x_um, y_um, z_um, asphericity, volume_ratio, area_ratio, inclination_deg, "
      "inside_nodes, inside_ratio, flips, mean_velocity_mm_per_s, pressure_gradient_Pa_per_m, velocity_x_mm_per_s, "
      "taylor_deformation, angle_xz_deg, angle_xy_deg, extent_x_um, extent_y_um, extent_z_um, marker_y_dx_um, "
      "marker_y_dy_um, marker_y_dz_um, marker_z_dx_um, marker_z_dy_um, marker_z_dz_um, finite "
      "FROM sample WHERE point = (SELECT ordinal FROM point WHERE key = ?) ORDER BY step, cell");
  statement.bind(point);
  std::vector<SampleRow> samples;
  while (statement.step()) samples.push_back(sample_in(statement));
  return samples;
}

void Store::put_samples(std::string_view point, std::span<const SampleRow> samples) {
  Transaction transaction = begin();
  Statement find = database_.prepare("SELECT ordinal FROM point WHERE key = ?");
  find.bind(point);
  if (!find.step()) fail(Exit::not_found, "{}: has no point {}", database_.file().string(), point);
  const std::int64_t ordinal = find.integer(0);
  find.reset();
  Statement insert = database_.prepare(
      "INSERT OR REPLACE INTO sample (point, step, cell, time_s, d_um, x_um, y_um, z_um, asphericity, volume_ratio, "
      "area_ratio, inclination_deg, inside_nodes, inside_ratio, flips, mean_velocity_mm_per_s, "
      "pressure_gradient_Pa_per_m, velocity_x_mm_per_s, taylor_deformation, angle_xz_deg, angle_xy_deg, extent_x_um, "
      "extent_y_um, extent_z_um, marker_y_dx_um, marker_y_dy_um, marker_y_dz_um, marker_z_dx_um, marker_z_dy_um, "
      "marker_z_dz_um, finite) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const SampleRow& s : samples)
    insert
        .bind(ordinal, s.step, s.cell, s.time_s, s.d_um, s.x_um, s.y_um, s.z_um, s.asphericity, s.volume_ratio,
              s.area_ratio, s.inclination_deg, s.inside_nodes, s.inside_ratio, s.flips, s.mean_velocity_mm_per_s,
              s.pressure_gradient_Pa_per_m, s.velocity_x_mm_per_s, s.taylor_deformation, s.angle_xz_deg, s.angle_xy_deg,
              s.extent_x_um, s.extent_y_um, s.extent_z_um, s.marker_y_dx_um, s.marker_y_dy_um, s.marker_y_dz_um,
              s.marker_z_dx_um, s.marker_z_dy_um, s.marker_z_dz_um, s.finite)
        .run();
  transaction.commit();
}

void Store::delete_samples(std::string_view point) {
  database_.prepare("DELETE FROM sample WHERE point = (SELECT ordinal FROM point WHERE key = ?)").bind(point).run();
}

SampleMark Store::sample_mark(std::string_view point) const {
  Statement statement = database_.prepare("SELECT log_offset, log_tail_hash FROM point WHERE key = ?");
  statement.bind(point);
  return statement.step() ? SampleMark{statement.integer(0), statement.text(1)} : SampleMark{};
}

void Store::set_sample_mark(std::string_view point, const SampleMark& mark) {
  database_.prepare("UPDATE point SET log_offset = ?, log_tail_hash = ? WHERE key = ?")
      .bind(mark.offset, mark.tail_hash, point)
      .run();
}

}  // namespace rouleau::campaign
