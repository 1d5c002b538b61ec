// SPDX-License-Identifier: BSD-3-Clause
// The cells of a run at one time, as `rouleau-solver shape` prints them (share/contract.md section 13), and simple
// geometry of them. Lengths are in µm; the box starts at 0, its faces in y and z are the walls, x is periodic.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rouleau::campaign {

using Point3 = std::array<double, 3>;

/// A closed surface; triangles are counter-clockwise from outside.
struct CellMesh {
  std::vector<Point3> vertices_um;
  std::vector<std::array<int, 3>> triangles;
};

/// Which nodes of a plane are inside a cell: rows[k][i] is '1' for the node at first_node_um + spacing_um (i, k).
struct FlagSlice {
  int normal = 1;  ///< 1: a plane across y, rows along z; 2: across z, rows along y. Columns are along x
  double at_um = 0, first_node_um = 0, spacing_um = 0;
  std::vector<std::string> rows;
};

struct Shape {
  std::int64_t step = 0;
  double time_s = 0;
  Point3 box_um{};
  std::vector<CellMesh> cells;  ///< at least one
  std::optional<FlagSlice> slice;
};

/// Reads the answer of `rouleau-solver shape`; every cell is made whole.
/// throws  Error (damaged) if it is not what the contract says, `whose` leads the message
[[nodiscard]] Shape parse_shape(const std::string& json, const std::string& whose);

/// Joins a cell that is cut by the periodic seam in x, by going along its edges, and puts its mean vertex into the box.
void make_whole(CellMesh& cell, double period_um);

/// The centre of the enclosed volume; the mean vertex if it encloses none.
[[nodiscard]] Point3 centre_of(const CellMesh& cell);

/// Distance of the centre from the axis of the channel.
[[nodiscard]] double displacement_um(const Shape& shape, const CellMesh& cell);

/// A cell of fewer triangles that looks alike from afar: vertices in the same cube of edge `grain_um` become one.
[[nodiscard]] CellMesh coarsened(const CellMesh& cell, double grain_um);

/// Where the plane [normal] = at_um cuts the surface: segments, each as its two ends.
[[nodiscard]] std::vector<std::array<Point3, 2>> cut(const CellMesh& cell, int normal, double at_um);

}  // namespace rouleau::campaign
