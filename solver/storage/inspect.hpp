// SPDX-License-Identifier: BSD-3-Clause
// Looking into a checkpoint file without a run: what it holds, whether it is sound, the shape of one cell. Needs no
// MPI.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "membrane/cells.hpp"
#include "storage/file_system.hpp"
#include "storage/metadata.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

struct ItemSummary {
  std::string name;
  ElementType type;
  bool on_lattice = false;
  std::vector<std::uint64_t> shape;
  std::uint64_t bytes = 0;
  std::vector<std::uint64_t> checksums;  ///< one a component; replicated items have one
};

/// Positions in lattice units of the run that wrote the file.
struct CellSummary {
  std::int64_t vertices = 0, triangles = 0;
  Vec3 centre = Vec3::Zero();  ///< mean of the vertices
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
};

struct CheckpointReport {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  CheckpointMetadata metadata;
  Int3 lattice{};
  std::vector<ItemSummary> items;
  std::vector<CellSummary> cells;
  std::string digest;  ///< see digest() in checkpoint.hpp
};

/// Everything there is to print. Checks seal, manifest and metadata. Throws Error(bad_input) if the file is damaged.
[[nodiscard]] CheckpointReport inspect_checkpoint(FileSystem& files, const std::filesystem::path& file);

struct VerificationLine {
  std::string what;  ///< "seal", "manifest", "metadata", or an item's name
  bool sound = false;
  std::string detail;
};

struct Verification {
  bool sound = false;
  std::vector<VerificationLine> lines;  ///< ends at the first failure that makes the rest unreadable
};

/// Full check: every byte of the file and every value against its checksum. Throws Error(io) only if the file cannot be
/// opened.
[[nodiscard]] Verification verify_checkpoint(FileSystem& files, const std::filesystem::path& file);

/// The deformed mesh of one cell, to start a new run from.
struct SavedCell {
  Surface surface;          ///< vertices in lattice units of the file; triangle indices start at 0
  VectorArray X_reference;  ///< stress-free shape, lattice units of the file
  double node_spacing_um = 0;
  Int3 lattice{};  ///< nodes of the file's channel
};

/// Reads items "cells/X" f64 [3][V], "cells/X_reference" f64 [3][V], "cells/triangles" i32 [3][T] and
/// "cells/ranges" i32 [cells][4] (vertex begin, vertex end, triangle begin, triangle end).
/// throws  Error(bad_input) if the file is damaged, lacks one of them or has no cell of that number
[[nodiscard]] SavedCell read_cell(FileSystem& files, const std::filesystem::path& file, int cell);

/// The inside flags of a block of the lattice, [z][y][x].
/// throws  Error(bad_input) if the file is damaged or the block leaves its lattice
[[nodiscard]] std::vector<std::uint8_t> read_flags(FileSystem& files, const std::filesystem::path& file,
                                                   const Block& block);

}  // namespace rouleau
