// SPDX-License-Identifier: BSD-3-Clause
// Writing the HDF5 file of a snapshot.
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "storage/files.hpp"
#include "storage/hdf5_driver.hpp"
#include "storage/hdf5_handle.hpp"
#include "storage/snapshot.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

using hdf5::check;
using hdf5::Handle;

constexpr std::size_t step_digits = 12;
constexpr unsigned deflate_level = 4;
/// A chunk holds whole layers of the first axis, up to about so many bytes.
constexpr std::uint64_t chunk_bytes = 1U << 20U;
/// Room for what is not an array.
constexpr std::uint64_t overhead_bytes = 64U << 10U;

constexpr std::string_view prefix(SnapshotKind kind) { return kind == SnapshotKind::cells ? "cells-" : ""; }

struct StoredArray {
  const char* name;
  ElementType type;
  std::vector<hsize_t> shape;
  const void* data;
};

std::uint64_t bytes_of(const StoredArray& array) {
  std::uint64_t bytes = element_size(array.type);
  for (const hsize_t n : array.shape) bytes *= n;
  return bytes;
}

std::vector<StoredArray> arrays_of(const FieldSnapshot& s) {
  using enum ElementType;
  const auto n = [&](std::size_t axis) { return static_cast<hsize_t>(s.size[axis]); };
  return {{"velocity_mm_per_s", f32, {n(2), n(1), n(0), 3}, s.velocity_mm_per_s.data()},
          {"pressure_Pa", f32, {n(2), n(1), n(0)}, s.pressure_Pa.data()},
          {"inside", u8, {n(2), n(1), n(0)}, s.inside.data()},
          {"membrane_force_pN_per_um3", f32, {n(2), n(1), n(0), 3}, s.membrane_force_pN_per_um3.data()}};
}

std::vector<StoredArray> arrays_of(const CellSnapshot& s) {
  using enum ElementType;
  const hsize_t vertices = s.vertices_um.size() / 3, triangles = s.triangles.size() / 3,
                cells = s.cell_ranges.size() / 4;
  return {{"vertices_um", f32, {vertices, 3}, s.vertices_um.data()},
          {"tension_uN_per_m", f32, {vertices}, s.tension_uN_per_m.data()},
          {"area_strain", f32, {vertices}, s.area_strain.data()},
          {"mean_curvature_per_um", f32, {vertices}, s.mean_curvature_per_um.data()},
          {"force_pN", f32, {vertices, 3}, s.force_pN.data()},
          {"triangles", i32, {triangles, 3}, s.triangles.data()},
          {"cell", i32, {triangles}, s.cell.data()},
          {"cell_ranges", i32, {cells, 4}, s.cell_ranges.data()},
          {"cell_periods", i32, {cells, 3}, s.cell_periods.data()}};
}

template <class T>
void write_attribute(const Handle& file, const char* name, hid_t type, const T* values, hsize_t count,
                     const std::string& path) {
  const Handle space(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle made(
      check(H5Acreate2(file.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), path, name, Exit::io), H5Aclose);
  check(H5Awrite(made.id(), type, values), path, name, Exit::io);
}

void write_moment(const Handle& file, const SnapshotMoment& moment, const std::string& path) {
  write_attribute(file, "layout", H5T_STD_I64LE, &snapshot_layout, 1, path);
  write_attribute(file, "step", H5T_STD_I64LE, &moment.step, 1, path);
  write_attribute(file, "time_s", H5T_IEEE_F64LE, &moment.time_s, 1, path);
  write_attribute(file, "box_um", H5T_IEEE_F64LE, moment.box_um.data(), 3, path);
  write_attribute(file, "node_spacing_um", H5T_IEEE_F64LE, &moment.node_spacing_um, 1, path);
}

void write_array(const Handle& file, const StoredArray& array, const std::string& path) {
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(create.id(), false);
  std::vector<hsize_t> chunk = array.shape;
  const std::uint64_t layer = bytes_of(array) / chunk[0];
  chunk[0] = std::clamp<hsize_t>(chunk_bytes / layer, 1, chunk[0]);
  H5Pset_chunk(create.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(create.id());
  H5Pset_deflate(create.id(), deflate_level);
  H5Pset_fletcher32(create.id());
  const Handle space(H5Screate_simple(static_cast<int>(array.shape.size()), array.shape.data(), nullptr), H5Sclose);
  const hid_t type = hdf5::element_type(array.type);
  Handle data(check(H5Dcreate2(file.id(), array.name, type, space.id(), H5P_DEFAULT, create.id(), H5P_DEFAULT), path,
                    array.name, Exit::io),
              H5Dclose);
  check(H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.data), path, array.name, Exit::io);
  check(data.close(), path, array.name, Exit::io);
}

template <class Attributes>
void write_file(FileSystem& files, const fs::path& path, const std::vector<StoredArray>& arrays,
                const Attributes& attributes) {
  hdf5::silence();
  const std::string name = path.string();
  hdf5::Ground ground{files, {}};
  // The index of chunks has a checksum since 1.10: a damaged one would otherwise read as an array of zeros.
  const Handle access = hdf5::access_through(ground, H5F_LIBVER_V110);
  const Handle create(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(create.id(), false);
  const hid_t created = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, create.id(), access.id());
  ground.rethrow();
  Handle file(check(created, name, "creating", Exit::io), H5Fclose);
  attributes(file, name);
  for (const StoredArray& array : arrays) write_array(file, array, name);
  check(file.close(), name, "closing", Exit::io);
  ground.rethrow();
}

template <class Attributes>
std::uint64_t commit(const SnapshotPlace& place, const std::string& name, const std::vector<StoredArray>& arrays,
                     const Attributes& attributes) {
  const fs::path unfinished = place.directory / unfinished_name(name, place.attempt);
  std::uint64_t needed = overhead_bytes;
  for (const StoredArray& array : arrays) needed += bytes_of(array);
  place.fence();
  make_directory(place.files, place.directory);
  require_free_space(place.files, place.directory, "a snapshot", needed);
  try {
    write_file(place.files, unfinished, arrays, attributes);
    sync_file(place.files, unfinished);
    const std::uint64_t bytes = file_size(place.files, unfinished);
    place.fence();
    rename_synced(place.files, unfinished, place.directory / name);
    return bytes;
  } catch (const Error&) {
    place.files.unlink(unfinished.string());  // if it is still there
    throw;
  }
}

}  // namespace

std::string snapshot_name(SnapshotKind kind, std::int64_t step) {
  return fmt::format("{}{:012}.h5", prefix(kind), step);
}

std::optional<std::int64_t> step_of_snapshot(SnapshotKind kind, const std::string& name) {
  const std::size_t begin = prefix(kind).size();
  if (name.size() < begin + step_digits + 3) return {};
  std::int64_t step = 0;
  const auto result = std::from_chars(name.data() + begin, name.data() + name.size(), step);
  if (result.ec != std::errc{} || step < 0 || name != snapshot_name(kind, step)) return {};
  return step;
}

std::uint64_t write_snapshot(const SnapshotPlace& place, const FieldSnapshot& snapshot) {
  return commit(place, snapshot_name(SnapshotKind::fields, snapshot.moment.step), arrays_of(snapshot),
                [&](const Handle& file, const std::string& path) {
                  write_moment(file, snapshot.moment, path);
                  write_attribute(file, "stride", H5T_STD_I64LE, &snapshot.stride, 1, path);
                });
}

std::uint64_t write_snapshot(const SnapshotPlace& place, const CellSnapshot& snapshot) {
  require(!snapshot.cell_ranges.empty(), "a snapshot of cells needs a cell");
  return commit(place, snapshot_name(SnapshotKind::cells, snapshot.moment.step), arrays_of(snapshot),
                [&](const Handle& file, const std::string& path) { write_moment(file, snapshot.moment, path); });
}

std::uint64_t uncompressed_field_bytes(const Int3& size) {
  FieldSnapshot empty;
  empty.size = size;
  std::uint64_t bytes = 0;
  for (const StoredArray& array : arrays_of(empty)) bytes += bytes_of(array);
  return bytes;
}

std::uint64_t uncompressed_cell_bytes(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t cells) {
  return vertices * 9 * sizeof(float) + (triangles * 4 + cells * 7) * sizeof(std::int32_t);
}

}  // namespace rouleau
