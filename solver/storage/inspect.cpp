// SPDX-License-Identifier: BSD-3-Clause
// Inspecting and verifying a checkpoint file, and taking one cell out of it.
#include "storage/inspect.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.hpp"
#include "storage/checkpoint_file.hpp"
#include "storage/checksum.hpp"
#include "storage/files.hpp"
#include "storage/seal.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

CheckpointFile open_sealed(FileSystem& files, const fs::path& path) {
  require_seal(files, path);
  CheckpointFile file(files, path);
  if (!file.readable()) {
    fail(Exit::bad_input, "{}: layout version {} (written by rouleau {}), this solver reads {}. Use that version.",
         path.string(), file.metadata().layout, file.metadata().version, checkpoint_layout);
  }
  return file;
}

/// A replicated item of the wanted type and leading or trailing size, with its checksum verified.
template <class T>
std::vector<T> read_item(const CheckpointFile& file, const fs::path& path, const std::string& name, ElementType type,
                         std::size_t axis, std::uint64_t size) {
  const ManifestItem* item = file.find(name);
  if (item == nullptr)
    fail(Exit::bad_input, "{}: holds no {}; it was written by a run without a cell", path.string(), name);
  if (item->on_lattice || item->type != type || item->shape.size() != 2 || item->shape[axis] != size) {
    fail(Exit::bad_input, "{}: {} does not have the type and shape of a cell's array", path.string(), name);
  }
  std::vector<T> values(item_bytes(*item, path.string()) / sizeof(T));
  file.read_all(*item, values.data());
  if (row_checksum(type, values.data(), values.size(), 0) != item->checksums[0]) {
    fail(Exit::bad_input, "{}: {} does not match its checksum", path.string(), name);
  }
  return values;
}

/// The cells' arrays as they stand in the file.
struct CellArrays {
  std::vector<double> X;
  std::vector<std::int32_t> ranges;
  std::size_t vertices = 0;

  CellArrays(const CheckpointFile& file, const fs::path& path)
      : X(read_item<double>(file, path, "cells/X", ElementType::f64, 0, 3)),
        ranges(read_item<std::int32_t>(file, path, "cells/ranges", ElementType::i32, 1, 4)),
        vertices(X.size() / 3) {}
  [[nodiscard]] std::size_t cells() const { return ranges.size() / 4; }
  [[nodiscard]] std::array<std::size_t, 4> range(const fs::path& path, std::size_t cell, std::size_t triangles) const {
    const std::int32_t* r = ranges.data() + 4 * cell;
    const bool sound = r[0] >= 0 && r[0] <= r[1] && static_cast<std::size_t>(r[1]) <= vertices && r[2] >= 0 &&
                       r[2] <= r[3] && static_cast<std::size_t>(r[3]) <= triangles;
    if (!sound) fail(Exit::bad_input, "{}: the range of cell {} leaves its arrays", path.string(), cell);
    return {static_cast<std::size_t>(r[0]), static_cast<std::size_t>(r[1]), static_cast<std::size_t>(r[2]),
            static_cast<std::size_t>(r[3])};
  }
};

std::uint64_t triangle_count(const CheckpointFile& file) {
  const ManifestItem* item = file.find("cells/triangles");
  return item == nullptr || item->shape.empty() ? 0 : item->shape.back();
}

std::vector<CellSummary> summarise_cells(const CheckpointFile& file, const fs::path& path) {
  std::vector<CellSummary> summaries;
  if (file.find("cells/ranges") == nullptr || file.find("cells/X") == nullptr) return summaries;
  const CellArrays arrays(file, path);
  for (std::size_t cell = 0; cell < arrays.cells(); ++cell) {
    const auto [begin, end, first, last] = arrays.range(path, cell, triangle_count(file));
    CellSummary& summary = summaries.emplace_back();
    summary.vertices = static_cast<std::int64_t>(end - begin);
    summary.triangles = static_cast<std::int64_t>(last - first);
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3 X(arrays.X[v], arrays.X[arrays.vertices + v], arrays.X[2 * arrays.vertices + v]);
      summary.lower = v == begin ? X : Vec3(summary.lower.cwiseMin(X));
      summary.upper = v == begin ? X : Vec3(summary.upper.cwiseMax(X));
      summary.centre += X / static_cast<double>(end - begin);
    }
  }
  return summaries;
}

/// Plane by plane, so that a file larger than the memory can be verified.
void verify_lattice_item(const CheckpointFile& file, const fs::path& path, const ManifestItem& item) {
  const Lattice lattice{file.manifest().lattice, {}};
  std::vector<std::byte> packed;
  for (std::size_t c = 0; c < item.shape[0]; ++c) {
    std::uint64_t sum = 0;
    for (int z = 0; z < lattice.size[2]; ++z) {
      const Block plane{{0, 0, z}, {lattice.size[0], lattice.size[1], 1}};
      packed.resize(node_count(plane) * element_size(item.type));
      file.read_block(item, c, plane, packed.data());
      sum += block_checksum({item.type, packed.data(), plane.size[0], 0}, lattice, plane);
    }
    if (sum != item.checksums[c]) {
      fail(Exit::bad_input, "{}: {} component {} does not match its checksum", path.string(), item.name, c);
    }
  }
}

void verify_replicated_item(const CheckpointFile& file, const fs::path& path, const ManifestItem& item) {
  std::vector<std::byte> values(item_bytes(item, path.string()));
  file.read_all(item, values.data());
  if (row_checksum(item.type, values.data(), values.size() / element_size(item.type), 0) != item.checksums[0]) {
    fail(Exit::bad_input, "{}: {} does not match its checksum", path.string(), item.name);
  }
}

}  // namespace

CheckpointReport inspect_checkpoint(FileSystem& files, const fs::path& path) {
  const CheckpointFile file = open_sealed(files, path);
  CheckpointReport report;
  report.file = path;
  report.bytes = file_size(files, path);
  report.metadata = file.metadata();
  report.lattice = file.manifest().lattice;
  for (const ManifestItem& item : file.manifest().items) {
    report.items.push_back(
        {item.name, item.type, item.on_lattice, item.shape, item_bytes(item, path.string()), item.checksums});
  }
  report.cells = summarise_cells(file, path);
  report.digest = digest(file.manifest());
  return report;
}

Verification verify_checkpoint(FileSystem& files, const fs::path& path) {
  Verification verification;
  const auto examine = [&](const std::string& what, const std::string& detail, const auto& work) {
    try {
      work();
      verification.lines.push_back({what, true, detail});
    } catch (const Error& error) {
      if (error.code() != Exit::bad_input) throw;
      verification.lines.push_back({what, false, error.what()});
    }
    return verification.lines.back().sound;
  };
  const std::uint64_t bytes = file_size(files, path);
  if (!examine("seal", fmt::format("{} bytes", bytes), [&] { require_seal(files, path); })) return verification;
  std::optional<CheckpointFile> file;
  if (!examine("manifest and metadata", "checksums match", [&] { file.emplace(open_sealed(files, path)); })) {
    return verification;
  }
  verification.sound = true;
  for (const ManifestItem& item : file->manifest().items) {
    const std::string detail = fmt::format("{} bytes", item_bytes(item, path.string()));
    verification.sound &= examine(item.name, detail, [&] {
      item.on_lattice ? verify_lattice_item(*file, path, item) : verify_replicated_item(*file, path, item);
    });
  }
  return verification;
}

SavedCell read_cell(FileSystem& files, const fs::path& path, int cell) {
  const CheckpointFile file = open_sealed(files, path);
  const CellArrays arrays(file, path);
  if (cell < 0 || static_cast<std::size_t>(cell) >= arrays.cells()) {
    fail(Exit::bad_input, "{}: there is no cell {}; it holds {} (numbers start at 0)", path.string(), cell,
         arrays.cells());
  }
  const auto reference = read_item<double>(file, path, "cells/X_reference", ElementType::f64, 0, 3);
  const auto corners = read_item<std::int32_t>(file, path, "cells/triangles", ElementType::i32, 0, 3);
  if (reference.size() != arrays.X.size()) {
    fail(Exit::bad_input, "{}: cells/X and cells/X_reference differ in size", path.string());
  }
  const std::size_t triangles = corners.size() / 3;
  const std::array<std::size_t, 4> range = arrays.range(path, static_cast<std::size_t>(cell), triangles);
  const std::size_t begin = range[0], end = range[1];

  SavedCell saved;
  saved.node_spacing_um = file.metadata().node_spacing_um;
  saved.lattice = file.manifest().lattice;
  saved.surface.X.resize(end - begin);
  saved.X_reference.resize(end - begin);
  for (std::size_t v = begin; v < end; ++v) {
    const std::size_t n = arrays.vertices;
    set(saved.surface.X, v - begin, {arrays.X[v], arrays.X[n + v], arrays.X[2 * n + v]});
    set(saved.X_reference, v - begin, {reference[v], reference[n + v], reference[2 * n + v]});
  }
  const auto corner = [&](std::size_t row, std::size_t t) {
    const std::int32_t v = corners[row * triangles + t];
    if (v < static_cast<std::int32_t>(begin) || v >= static_cast<std::int32_t>(end)) {
      fail(Exit::bad_input, "{}: triangle {} uses vertex {}, which is not one of cell {}", path.string(), t, v, cell);
    }
    return v - static_cast<std::int32_t>(begin);
  };
  for (std::size_t t = range[2]; t < range[3]; ++t) {
    saved.surface.triangles.a.push_back(corner(0, t));
    saved.surface.triangles.b.push_back(corner(1, t));
    saved.surface.triangles.c.push_back(corner(2, t));
  }
  return saved;
}

std::vector<std::uint8_t> read_flags(FileSystem& files, const fs::path& path, const Block& block) {
  const CheckpointFile file = open_sealed(files, path);
  const ManifestItem* item = file.find("interior/flags");
  if (item == nullptr || !item->on_lattice || item->type != ElementType::u8)
    fail(Exit::bad_input, "{}: holds no inside flags", path.string());
  std::vector<std::uint8_t> flags(node_count(block));
  file.read_block(*item, 0, block, flags.data());
  return flags;
}

}  // namespace rouleau
