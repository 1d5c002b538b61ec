// SPDX-License-Identifier: BSD-3-Clause
// XDMF for snapshots: a temporal collection of uniform grids (xdmf.org, versions 2 and 3).
#include "storage/snapshot_series.hpp"

#include <cstdio>
#include <set>

#include "base/error.hpp"
#include "storage/files.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace {

std::string data_item(const std::string& file, const char* name, const std::string& dimensions, const char* number_type,
                      int precision) {
  return fmt::format(R"(<DataItem Format="HDF" Dimensions="{}" NumberType="{}" Precision="{}">{}:/{}</DataItem>)",
                     dimensions, number_type, precision, file, name);
}

std::string attribute(const char* name, const char* type, const char* centre, const std::string& item) {
  return fmt::format("    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n", name, type,
                     centre, item);
}

std::string numbers(double value) {
  return fmt::format(R"(<DataItem Format="XML" Dimensions="3" NumberType="Float" Precision="8">{0} {0} {0}</DataItem>)",
                     value);
}

/// Dimensions in XDMF go from the slowest to the fastest: z y x. Origin and spacing are the same along all axes.
std::string field_grid(const std::string& file, const SnapshotSummary& s) {
  const std::string nodes = fmt::format("{} {} {}", s.size[2], s.size[1], s.size[0]);
  const double dx = s.moment.node_spacing_um;
  return fmt::format(
             "    <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{}\"/>\n"
             "    <Geometry GeometryType=\"ORIGIN_DXDYDZ\">{}{}</Geometry>\n",
             nodes, numbers(dx / 2), numbers(dx * static_cast<double>(s.stride))) +
         attribute("velocity_mm_per_s", "Vector", "Node",
                   data_item(file, "velocity_mm_per_s", nodes + " 3", "Float", 4)) +
         attribute("pressure_Pa", "Scalar", "Node", data_item(file, "pressure_Pa", nodes, "Float", 4)) +
         attribute("inside", "Scalar", "Node", data_item(file, "inside", nodes, "UChar", 1)) +
         attribute("membrane_force_pN_per_um3", "Vector", "Node",
                   data_item(file, "membrane_force_pN_per_um3", nodes + " 3", "Float", 4));
}

std::string cell_grid(const std::string& file, const SnapshotSummary& s) {
  const std::string vertices = fmt::format("{}", s.vertices), triangles = fmt::format("{}", s.triangles);
  std::string grid = fmt::format(
      "    <Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">{}</Topology>\n"
      "    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
      triangles, data_item(file, "triangles", triangles + " 3", "Int", 4),
      data_item(file, "vertices_um", vertices + " 3", "Float", 4));
  for (const char* name : {"tension_uN_per_m", "area_strain", "mean_curvature_per_um"})
    grid += attribute(name, "Scalar", "Node", data_item(file, name, vertices, "Float", 4));
  grid += attribute("force_pN", "Vector", "Node", data_item(file, "force_pN", vertices + " 3", "Float", 4));
  grid += attribute("cell", "Scalar", "Cell", data_item(file, "cell", triangles, "Int", 4));
  return grid;
}

std::string grid_of(FileSystem& files, const std::filesystem::path& path, SnapshotKind kind) {
  const SnapshotSummary s = summarise_snapshot(files, path, kind);
  const std::string file = path.filename().string();
  return fmt::format("   <Grid Name=\"step {}\" GridType=\"Uniform\">\n    <Time Value=\"{:.12g}\"/>\n{}   </Grid>\n",
                     s.moment.step, s.moment.time_s,
                     kind == SnapshotKind::fields ? field_grid(file, s) : cell_grid(file, s));
}

}  // namespace

void SnapshotSeries::write(const SnapshotPlace& place, const std::string& changed) {
  grids_.erase(changed);
  std::set<std::string> there;
  for (const std::string& name : list_directory(place.files, place.directory))
    if (step_of_snapshot(kind_, name)) there.insert(name);
  std::erase_if(grids_, [&](const auto& known) { return !there.contains(known.first); });
  for (const std::string& name : there) {
    if (grids_.contains(name)) continue;
    try {
      grids_[name] = grid_of(place.files, place.directory / name, kind_);
    } catch (const Error& error) {
      if (error.code() != Exit::bad_input) throw;
      grids_[name].clear();
      fmt::print(stderr, "the series of snapshots leaves out {}\n", error.what());
    }
  }

  const char* const kind = kind_ == SnapshotKind::fields ? "fields" : "cells";
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
      "  <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
      kind);
  for (const auto& [name, grid] : grids_) text += grid;
  text += "  </Grid>\n </Domain>\n</Xdmf>\n";
  write_fenced(place.files, place.directory / fmt::format("{}.xdmf", kind), text, place.attempt, place.fence);
}

}  // namespace rouleau
