// SPDX-License-Identifier: BSD-3-Clause
// Snapshots: what a run shows of itself at a step, in physical units, as HDF5 files for pictures.
//
// `snapshots/<step>.h5` holds the fields, `snapshots/cells-<step>.h5` the cells; each is complete in itself. Arrays
// stand at the top of the file under names that carry their units, compressed by chunks (shuffle, deflate, a checksum
// a chunk). Text and times of writing are left out: the same state gives the same bytes. Nothing of a run depends on
// a snapshot.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "storage/file_system.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// Version of the arrays and attributes of both kinds of files.
inline constexpr std::int64_t snapshot_layout = 1;

enum class SnapshotKind { fields, cells };

/// What both kinds say of themselves.
struct SnapshotMoment {
  std::int64_t step = 0;
  double time_s = 0;
  std::array<double, 3> box_um{};  ///< the box starts at 0; the walls, or the periodic seam, are its faces
  double node_spacing_um = 0;
};

/// Fields at every `stride`-th node: the kept node (i, j, k) lies at node_spacing_um (1/2 + stride (i, j, k)).
struct FieldSnapshot {
  SnapshotMoment moment;
  std::int64_t stride = 1;
  Int3 size{};                                   ///< nodes kept along x, y, z
  std::vector<float> velocity_mm_per_s;          ///< [z][y][x][3]
  std::vector<float> pressure_Pa;                ///< [z][y][x] without the fall that the body force stands for
  std::vector<std::uint8_t> inside;              ///< [z][y][x]
  std::vector<float> membrane_force_pN_per_um3;  ///< [z][y][x][3] on the fluid
};

/// All cells, one behind the other. Each is whole, also where it crosses the periodic seam, with its mean vertex in the
/// box.
struct CellSnapshot {
  SnapshotMoment moment;
  std::vector<float> vertices_um;            ///< [vertices][3]
  std::vector<float> tension_uN_per_m;       ///< [vertices]
  std::vector<float> area_strain;            ///< [vertices]
  std::vector<float> mean_curvature_per_um;  ///< [vertices] positive on a sphere
  std::vector<float> force_pN;               ///< [vertices][3] of the membrane on the fluid
  std::vector<std::int32_t> triangles;       ///< [triangles][3] vertices, counter-clockwise from outside
  std::vector<std::int32_t> cell;            ///< [triangles] the cell that each belongs to
  std::vector<std::int32_t> cell_ranges;     ///< [cells][4] vertex begin, end, triangle begin, end
  std::vector<std::int32_t> cell_periods;    ///< [cells][3] periods of the box that each has travelled
};

/// Where snapshots go and under which rules.
struct SnapshotPlace {
  FileSystem& files;
  std::filesystem::path directory;  ///< `snapshots/` of the run; made if missing
  std::function<void()> fence;      ///< throws Error(superseded) if a newer attempt exists
  int attempt = 1;
};

/// "000000000100.h5", "cells-000000000100.h5".
[[nodiscard]] std::string snapshot_name(SnapshotKind kind, std::int64_t step);
/// The step in a name of this kind; nothing for any other name.
[[nodiscard]] std::optional<std::int64_t> step_of_snapshot(SnapshotKind kind, const std::string& name);

/// Writes a file aside, syncs it, asks the fence, renames it over one of the same step, if there is one. For rank 0.
/// returns  the bytes of the file
/// throws   Error(superseded) by the fence, Error(io); then there is what was there before, and nothing unfinished
std::uint64_t write_snapshot(const SnapshotPlace& place, const FieldSnapshot& snapshot);
std::uint64_t write_snapshot(const SnapshotPlace& place, const CellSnapshot& snapshot);

/// Bytes of the arrays of a snapshot before compression.
[[nodiscard]] std::uint64_t uncompressed_field_bytes(const Int3& size);
[[nodiscard]] std::uint64_t uncompressed_cell_bytes(std::uint64_t vertices, std::uint64_t triangles,
                                                    std::uint64_t cells);

/// What a time series says of one file.
struct SnapshotSummary {
  SnapshotMoment moment;
  std::int64_t stride = 1;                    ///< of fields
  Int3 size{};                                ///< of fields
  std::uint64_t vertices = 0, triangles = 0;  ///< of cells
};

/// Reads attributes and shapes. throws Error(bad_input) if it is no sound snapshot of this kind, Error(io)
[[nodiscard]] SnapshotSummary summarise_snapshot(FileSystem& files, const std::filesystem::path& file,
                                                 SnapshotKind kind);

/// Reads what is needed of the cells' shapes: the moment, vertices, triangles, ranges and periods.
/// throws Error(bad_input) if it is no sound snapshot of cells, Error(io)
[[nodiscard]] CellSnapshot read_cell_shapes(FileSystem& files, const std::filesystem::path& file);

}  // namespace rouleau
