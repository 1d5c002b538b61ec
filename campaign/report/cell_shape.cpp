// SPDX-License-Identifier: BSD-3-Clause
// Reading without trust, and sums over triangles.
#include "report/cell_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "study/record.hpp"

namespace rouleau::campaign {
namespace {

using nlohmann::json;

constexpr std::size_t most_vertices = 4'000'000, axes = 3;

Point3 point_of(const json& value) {
  if (!value.is_array() || value.size() != axes) throw Damage("a point has no three numbers");
  return {strictly<double>(value[0]), strictly<double>(value[1]), strictly<double>(value[2])};
}

CellMesh cell_of(const json& value) {
  CellMesh cell;
  for (const json& vertex : value.at("vertices_um")) cell.vertices_um.push_back(point_of(vertex));
  if (cell.vertices_um.empty() || cell.vertices_um.size() > most_vertices)
    throw Damage("a cell has no or too many vertices");
  const int vertices = static_cast<int>(cell.vertices_um.size());
  for (const json& triangle : value.at("triangles")) {
    if (!triangle.is_array() || triangle.size() != axes) throw Damage("a triangle has no three corners");
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < axes; ++k) corners[k] = strictly<int>(triangle[k]);
    if (std::any_of(corners.begin(), corners.end(), [&](int v) { return v < 0 || v >= vertices; }))
      throw Damage("a triangle names a vertex that is not there");
    cell.triangles.push_back(corners);
  }
  return cell;
}

FlagSlice slice_of(const json& value) {
  FlagSlice slice;
  const auto normal = value.at("normal").get<std::string>();
  if (normal != "y" && normal != "z") throw Damage("a slice is neither across y nor z");
  slice.normal = normal == "y" ? 1 : 2;
  slice.at_um = strictly<double>(value.at("at_um"));
  slice.first_node_um = strictly<double>(value.at("first_node_um"));
  slice.spacing_um = strictly<double>(value.at("spacing_um"));
  for (const json& row : value.at("inside")) {
    slice.rows.push_back(row.get<std::string>());
    const std::string& digits = slice.rows.back();
    if (digits.size() != slice.rows.front().size() || digits.find_first_not_of("01") != std::string::npos)
      throw Damage("the rows of a slice are not equally many 0 and 1");
  }
  if (!(slice.spacing_um > 0) || slice.rows.empty() || slice.rows.front().empty()) throw Damage("a slice has no nodes");
  return slice;
}

Shape shape_of(const json& value) {
  Shape shape;
  shape.step = strictly<std::int64_t>(value.at("step"));
  shape.time_s = strictly<double>(value.at("time_s"));
  shape.box_um = point_of(value.at("box_um"));
  if (!(shape.box_um[0] > 0 && shape.box_um[1] > 0 && shape.box_um[2] > 0)) throw Damage("the box has no size");
  for (const json& cell : value.at("cells")) shape.cells.push_back(cell_of(cell));
  if (shape.cells.empty()) throw Damage("there is no cell");
  if (value.contains("slice")) shape.slice = slice_of(value.at("slice"));
  for (CellMesh& cell : shape.cells) make_whole(cell, shape.box_um[0]);
  return shape;
}

Point3 mean_of(const CellMesh& cell) {
  Point3 mean{};
  for (const Point3& vertex : cell.vertices_um)
    for (std::size_t k = 0; k < axes; ++k) mean[k] += vertex[k] / static_cast<double>(cell.vertices_um.size());
  return mean;
}

}  // namespace

Shape parse_shape(const std::string& text, const std::string& whose) {
  return read_record(text, whose, "; see that rouleau and rouleau-solver are of the same version", shape_of);
}

void make_whole(CellMesh& cell, double period_um) {
  std::vector<std::vector<int>> neighbours(cell.vertices_um.size());
  for (const std::array<int, 3>& t : cell.triangles)
    for (std::size_t k = 0; k < axes; ++k) {
      neighbours[static_cast<std::size_t>(t[k])].push_back(t[(k + 1) % axes]);
      neighbours[static_cast<std::size_t>(t[(k + 1) % axes])].push_back(t[k]);
    }
  std::vector<bool> is_placed(cell.vertices_um.size(), false);
  std::vector<int> front = {0};
  is_placed[0] = true;
  while (!front.empty()) {
    const auto v = static_cast<std::size_t>(front.back());
    front.pop_back();
    for (const int other : neighbours[v]) {
      const auto w = static_cast<std::size_t>(other);
      if (is_placed[w]) continue;
      double& x = cell.vertices_um[w][0];
      x -= period_um * std::round((x - cell.vertices_um[v][0]) / period_um);
      is_placed[w] = true;
      front.push_back(other);
    }
  }
  const double shift = period_um * std::floor(mean_of(cell)[0] / period_um);
  for (Point3& vertex : cell.vertices_um) vertex[0] -= shift;
}

Point3 centre_of(const CellMesh& cell) {
  const Point3 mean = mean_of(cell);
  double six_volumes = 0;
  Point3 moment{};
  for (const std::array<int, 3>& t : cell.triangles) {
    std::array<Point3, 3> p{};
    for (std::size_t k = 0; k < axes; ++k)
      for (std::size_t axis = 0; axis < axes; ++axis)
        p[k][axis] = cell.vertices_um[static_cast<std::size_t>(t[k])][axis] - mean[axis];
    const double six = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                       p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                       p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    six_volumes += six;
    for (std::size_t axis = 0; axis < axes; ++axis) moment[axis] += six * (p[0][axis] + p[1][axis] + p[2][axis]) / 4;
  }
  if (!(std::abs(six_volumes) > 1e-9)) return mean;
  return {mean[0] + moment[0] / six_volumes, mean[1] + moment[1] / six_volumes, mean[2] + moment[2] / six_volumes};
}

double displacement_um(const Shape& shape, const CellMesh& cell) {
  const Point3 centre = centre_of(cell);
  return std::hypot(centre[1] - shape.box_um[1] / 2, centre[2] - shape.box_um[2] / 2);
}

CellMesh coarsened(const CellMesh& cell, double grain_um) {
  CellMesh coarse;
  std::map<std::array<long, 3>, int> cubes;
  std::vector<int> new_of, members;
  for (const Point3& vertex : cell.vertices_um) {
    std::array<long, 3> cube{};
    for (std::size_t k = 0; k < axes; ++k) cube[k] = std::lround(std::floor(vertex[k] / grain_um));
    const auto [found, is_new] = cubes.try_emplace(cube, static_cast<int>(coarse.vertices_um.size()));
    if (is_new) {
      coarse.vertices_um.push_back({});
      members.push_back(0);
    }
    const auto i = static_cast<std::size_t>(found->second);
    for (std::size_t k = 0; k < axes; ++k) coarse.vertices_um[i][k] += vertex[k];
    ++members[i];
    new_of.push_back(found->second);
  }
  for (std::size_t i = 0; i < members.size(); ++i)
    for (double& coordinate : coarse.vertices_um[i]) coordinate /= members[i];
  for (const std::array<int, 3>& t : cell.triangles) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < axes; ++k) corners[k] = new_of[static_cast<std::size_t>(t[k])];
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      coarse.triangles.push_back(corners);
  }
  return coarse;
}

std::vector<std::array<Point3, 2>> cut(const CellMesh& cell, int normal, double at_um) {
  const auto n = static_cast<std::size_t>(normal);
  std::vector<std::array<Point3, 2>> segments;
  for (const std::array<int, 3>& t : cell.triangles) {
    std::vector<Point3> ends;
    for (std::size_t k = 0; k < axes; ++k) {
      const Point3& a = cell.vertices_um[static_cast<std::size_t>(t[k])];
      const Point3& b = cell.vertices_um[static_cast<std::size_t>(t[(k + 1) % axes])];
      if ((a[n] < at_um) == (b[n] < at_um)) continue;
      const double share = (at_um - a[n]) / (b[n] - a[n]);
      ends.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])});
    }
    if (ends.size() == 2) segments.push_back({ends[0], ends[1]});
  }
  return segments;
}

}  // namespace rouleau::campaign
