// SPDX-License-Identifier: BSD-3-Clause
#include "run/shape.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "storage/files.hpp"
#include "storage/inspect.hpp"
#include "storage/snapshot.hpp"

namespace rouleau {

using nlohmann::ordered_json;

namespace {

/// As many digits as single precision has at 10 um.
double rounded_um(double um) { return std::round(um * 1e6) / 1e6; }

/// A checkpoint starts with its seal, a snapshot with the signature of HDF5.
bool is_snapshot(FileSystem& files, const std::filesystem::path& path) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::string begin(signature.size(), '\0');
  begin.resize(File::read(files, path).read_at(0, begin.data(), begin.size()));
  return begin == signature;
}

ordered_json head(std::int64_t step, double time_s, const std::array<double, 3>& box_um, double node_spacing_um) {
  return {{"contract", 1},
          {"step", step},
          {"time_s", time_s},
          {"box_um", box_um},
          {"node_spacing_um", node_spacing_um},
          {"cells", ordered_json::array()}};
}

ordered_json shapes_of_snapshot(const std::filesystem::path& path, FileSystem& files) {
  const CellSnapshot s = read_cell_shapes(files, path);
  ordered_json answer = head(s.moment.step, s.moment.time_s, s.moment.box_um, s.moment.node_spacing_um);
  for (std::size_t r = 0; r < s.cell_ranges.size(); r += 4) {
    ordered_json vertices = ordered_json::array(), triangles = ordered_json::array();
    const std::int32_t first = s.cell_ranges[r];
    for (auto v = static_cast<std::size_t>(first); v < static_cast<std::size_t>(s.cell_ranges[r + 1]); ++v)
      vertices.push_back({rounded_um(s.vertices_um[3 * v]), rounded_um(s.vertices_um[3 * v + 1]),
                          rounded_um(s.vertices_um[3 * v + 2])});
    for (auto t = static_cast<std::size_t>(s.cell_ranges[r + 2]); t < static_cast<std::size_t>(s.cell_ranges[r + 3]);
         ++t)
      triangles.push_back({s.triangles[3 * t] - first, s.triangles[3 * t + 1] - first, s.triangles[3 * t + 2] - first});
    answer["cells"].push_back({{"vertices_um", std::move(vertices)}, {"triangles", std::move(triangles)}});
  }
  return answer;
}

/// The plane of nodes through a point (lattice units) across `normal`, a line of digits for each row.
ordered_json slice(const std::filesystem::path& path, const CheckpointReport& report, int normal, FileSystem& files) {
  const auto n = static_cast<std::size_t>(normal);
  const double dx = report.metadata.node_spacing_um;
  Block plane{{0, 0, 0}, report.lattice};
  plane.begin[n] = std::clamp(static_cast<int>(std::lround(report.cells[0].centre[normal])), 0, report.lattice[n] - 1);
  plane.size[n] = 1;
  const std::vector<std::uint8_t> flags = read_flags(files, path, plane);
  ordered_json rows = ordered_json::array();
  for (auto row = flags.begin(); row != flags.end(); row += plane.size[0]) {
    std::string digits;
    std::transform(row, row + plane.size[0], std::back_inserter(digits), [](auto flag) { return flag ? '1' : '0'; });
    rows.push_back(std::move(digits));
  }
  return {{"normal", normal == 1 ? "y" : "z"},
          {"at_um", rounded_um((plane.begin[n] + 0.5) * dx)},
          {"first_node_um", dx / 2},
          {"spacing_um", dx},
          {"columns", "x"},
          {"rows", normal == 1 ? "z" : "y"},
          {"inside", std::move(rows)}};
}

ordered_json shapes_of_checkpoint(const std::filesystem::path& path, std::optional<int> slice_normal,
                                  FileSystem& files) {
  const CheckpointReport report = inspect_checkpoint(files, path);
  const double dx = report.metadata.node_spacing_um;
  std::array<double, 3> box_um{};
  for (std::size_t axis = 0; axis < 3; ++axis) box_um[axis] = report.lattice[axis] * dx;
  ordered_json answer = head(report.metadata.step, report.metadata.time_s, box_um, dx);
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    const Surface surface = read_cell(files, path, static_cast<int>(c)).surface;
    ordered_json vertices = ordered_json::array(), triangles = ordered_json::array();
    for (std::size_t v = 0; v < surface.X.size(); ++v) {
      const Vec3 X = (at(surface.X, v) + Vec3::Constant(0.5)) * dx;
      vertices.push_back({rounded_um(X[0]), rounded_um(X[1]), rounded_um(X[2])});
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      triangles.push_back({surface.triangles.a[t], surface.triangles.b[t], surface.triangles.c[t]});
    answer["cells"].push_back({{"vertices_um", std::move(vertices)}, {"triangles", std::move(triangles)}});
  }
  if (report.cells.empty()) fail(Exit::bad_input, "{}: was written by a run without a cell", path.string());
  if (slice_normal) answer["slice"] = slice(path, report, *slice_normal, files);
  return answer;
}

}  // namespace

std::string shape_text(const std::filesystem::path& path, std::optional<int> slice_normal, FileSystem& files) {
  const bool snapshot = is_snapshot(files, path);
  if (snapshot && slice_normal)
    fail(Exit::bad_input, "{}: a snapshot of cells holds no flags. Take --slice of a checkpoint.", path.string());
  const ordered_json answer =
      snapshot ? shapes_of_snapshot(path, files) : shapes_of_checkpoint(path, slice_normal, files);
  return answer.dump() + "\n";
}

}  // namespace rouleau
