// SPDX-License-Identifier: BSD-3-Clause
#include "run/sampling.hpp"

#include "membrane/measures.hpp"
#include "membrane/solid_moments.hpp"
#include "membrane/volume.hpp"

namespace rouleau {

namespace {

void append_shape(SampleRow& row, const Eigen::Matrix3d& moments, const Vec3& extent, const Units& units) {
  const PlaneEllipse in_xz = ellipse_in_plane(moments, 2), in_xy = ellipse_in_plane(moments, 1);
  row.insert(row.end(), {in_xz.deformation(), in_xz.angle_deg, in_xy.angle_deg, units.length_um(extent[0]),
                         units.length_um(extent[1]), units.length_um(extent[2])});
}

void append_markers(SampleRow& row, const Cells& cells, const Markers& markers, const Vec3& centre,
                    const Units& units) {
  for (const std::int32_t v : {markers.y, markers.z})
    for (int axis = 0; axis < 3; ++axis)
      row.emplace_back(units.length_um(at(cells.X, static_cast<std::size_t>(v))[axis] - centre[axis]));
}

}  // namespace

std::vector<std::string> sample_columns() {
  return {"step",
          "time_s",
          "cell",
          "d_um",
          "x_um",
          "y_um",
          "z_um",
          "asphericity",
          "volume_ratio",
          "area_ratio",
          "inclination_deg",
          "inside_nodes",
          "inside_ratio",
          "flips",
          "mean_velocity_mm_per_s",
          "pressure_gradient_Pa_per_m",
          "velocity_x_mm_per_s",
          "taylor_deformation",
          "angle_xz_deg",
          "angle_xy_deg",
          "extent_x_um",
          "extent_y_um",
          "extent_z_um",
          "marker_y_dx_um",
          "marker_y_dy_um",
          "marker_y_dz_um",
          "marker_z_dx_um",
          "marker_z_dy_um",
          "marker_z_dz_um"};
}

Sample take_sample(const Simulation& simulation, const Setup& setup) {
  const Units& units = setup.units;
  const Lattice& lattice = setup.lattice.lattice;
  const Cells& cells = simulation.cells();
  const std::int64_t step = simulation.steps_done();
  const std::int64_t inside = simulation.inside_nodes();
  const double mean_velocity = units.speed_mm_per_s(simulation.mean_velocity());
  const double gradient = units.pressure_gradient_Pa_per_m(simulation.body_force());

  double total_volume = 0;
  for (std::size_t c = 0; c < cells.ranges.size(); ++c) total_volume += volume(cells, c);

  Sample sample;
  for (std::size_t c = 0; c < cells.ranges.size(); ++c) {
    const CellMeasures m = measure(cells, c);
    Vec3 centre = m.centre_of_mass;
    for (int axis = 0; axis < 3; ++axis)
      centre[axis] += static_cast<double>(cells.images[c][axis]) * lattice.size[axis];
    const double dy = m.centre_of_mass[1] - (lattice.size[1] - 1) / 2.0;
    const double dz = m.centre_of_mass[2] - (lattice.size[2] - 1) / 2.0;
    const double d_um = units.length_um(std::sqrt(dy * dy + dz * dz));
    sample.rows.push_back({step, units.time_s(step), static_cast<std::int64_t>(c), d_um, units.coordinate_um(centre[0]),
                           units.length_um(dy), units.length_um(dz), m.asphericity, m.volume_ratio, m.area_ratio,
                           m.inclination_deg, inside, static_cast<double>(inside) / total_volume, simulation.flips(),
                           mean_velocity, gradient, units.speed_mm_per_s(m.velocity[0])});
    append_shape(sample.rows.back(), solid_moments(cells, c), m.extents, units);
    append_markers(sample.rows.back(), cells, setup.cells.markers[c], m.centre_of_mass, units);
    if (c == 0) {
      sample.d_um = d_um;
      sample.asphericity = m.asphericity;
    }
  }
  if (sample.rows.empty()) {
    sample.rows.push_back({step, units.time_s(step), std::int64_t{0}, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, inside,
                           0.0, simulation.flips(), mean_velocity, gradient, 0.0});
    sample.rows.back().resize(sample_columns().size(), 0.0);
  }
  return sample;
}

}  // namespace rouleau
