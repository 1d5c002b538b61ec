// SPDX-License-Identifier: BSD-3-Clause
// Reading snapshots: what a time series needs to know of a file, and the shapes of its cells.
#include <algorithm>

#include "storage/files.hpp"
#include "storage/hdf5_driver.hpp"
#include "storage/hdf5_handle.hpp"
#include "storage/snapshot.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

using hdf5::Handle;

/// More than deflate can compress: a larger array does not fit into the file.
constexpr std::uint64_t largest_compression = 1100;

class SnapshotFile {
 public:
  SnapshotFile(FileSystem& files, const fs::path& path)
      : name_(path.string()), length_(file_size(files, path)), ground_{files, {}} {
    hdf5::silence();
    const Handle access = hdf5::access_through(ground_);
    file_ = {check(H5Fopen(name_.c_str(), H5F_ACC_RDONLY, access.id()), "opening"), H5Fclose};
    std::int64_t layout = 0;
    read_attribute("layout", H5T_STD_I64LE, &layout, 1);
    if (layout != snapshot_layout)
      fail(Exit::bad_input, "{}: snapshot of layout version {}, this solver reads {}", name_, layout, snapshot_layout);
  }

  [[nodiscard]] SnapshotMoment moment() const {
    SnapshotMoment moment;
    read_attribute("step", H5T_STD_I64LE, &moment.step, 1);
    read_attribute("time_s", H5T_IEEE_F64LE, &moment.time_s, 1);
    read_attribute("box_um", H5T_IEEE_F64LE, moment.box_um.data(), 3);
    read_attribute("node_spacing_um", H5T_IEEE_F64LE, &moment.node_spacing_um, 1);
    return moment;
  }
  [[nodiscard]] std::int64_t stride() const {
    std::int64_t stride = 0;
    read_attribute("stride", H5T_STD_I64LE, &stride, 1);
    return stride;
  }

  /// throws Error(bad_input) unless there is such an array with so many axes
  [[nodiscard]] std::vector<std::uint64_t> shape(const char* name, ElementType type, std::size_t axes) const {
    return shape(open(name), name, type, axes);
  }
  template <class T>
  [[nodiscard]] std::vector<T> read(const char* name, ElementType type, std::size_t columns) const {
    const Handle data = open(name);
    const auto size = shape(data, name, type, 2);
    if (size[1] != columns) fail(Exit::bad_input, "{}: {} has {} columns instead of {}", name_, name, size[1], columns);
    std::vector<T> values(size[0] * size[1]);
    check(H5Dread(data.id(), hdf5::element_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
    return values;
  }

 private:
  /// What the file system said counts for more than what the library made of it.
  template <class T>
  T check(T value, const std::string& what) const {
    ground_.rethrow();
    return hdf5::check(value, name_, what, Exit::bad_input);
  }
  [[nodiscard]] Handle open(const char* name) const {
    return {check(H5Dopen2(file_.id(), name, H5P_DEFAULT), name), H5Dclose};
  }
  [[nodiscard]] std::vector<std::uint64_t> shape(const Handle& data, const char* name, ElementType type,
                                                 std::size_t axes) const {
    const Handle stored(H5Dget_type(data.id()), H5Tclose);
    const Handle space(H5Dget_space(data.id()), H5Sclose);
    std::vector<hsize_t> size(axes);
    if (H5Tequal(stored.id(), hdf5::element_type(type)) <= 0 ||
        H5Sget_simple_extent_ndims(space.id()) != static_cast<int>(axes) ||
        H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) < 0)
      fail(Exit::bad_input, "{}: {} is not the array of a snapshot", name_, name);
    std::uint64_t left = length_ * largest_compression / element_size(type);
    for (const hsize_t n : size) {
      if (n == 0 || n > left) fail(Exit::bad_input, "{}: the size of {} is not that of a sound file", name_, name);
      left /= n;
    }
    return {size.begin(), size.end()};
  }
  void read_attribute(const char* name, hid_t type, void* values, hssize_t count) const {
    const Handle attribute(check(H5Aopen(file_.id(), name, H5P_DEFAULT), name), H5Aclose);
    const Handle stored(H5Aget_type(attribute.id()), H5Tclose);
    const Handle space(H5Aget_space(attribute.id()), H5Sclose);
    if (H5Tequal(stored.id(), type) <= 0 || H5Sget_simple_extent_npoints(space.id()) != count)
      fail(Exit::bad_input, "{}: {} is not the attribute of a snapshot", name_, name);
    check(H5Aread(attribute.id(), type, values), name);
  }

  std::string name_;
  std::uint64_t length_;
  hdf5::Ground ground_;
  Handle file_;
};

}  // namespace

SnapshotSummary summarise_snapshot(FileSystem& files, const fs::path& path, SnapshotKind kind) {
  using enum ElementType;
  const SnapshotFile file(files, path);
  SnapshotSummary summary;
  summary.moment = file.moment();
  if (kind == SnapshotKind::fields) {
    summary.stride = file.stride();
    const auto size = file.shape("pressure_Pa", f32, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) summary.size[axis] = static_cast<int>(size[2 - axis]);
  } else {
    summary.vertices = file.shape("vertices_um", f32, 2)[0];
    summary.triangles = file.shape("triangles", i32, 2)[0];
  }
  return summary;
}

CellSnapshot read_cell_shapes(FileSystem& files, const fs::path& path) {
  using enum ElementType;
  const SnapshotFile file(files, path);
  CellSnapshot shapes;
  shapes.moment = file.moment();
  shapes.vertices_um = file.read<float>("vertices_um", f32, 3);
  shapes.triangles = file.read<std::int32_t>("triangles", i32, 3);
  shapes.cell_ranges = file.read<std::int32_t>("cell_ranges", i32, 4);
  shapes.cell_periods = file.read<std::int32_t>("cell_periods", i32, 3);
  const auto vertices = static_cast<std::int32_t>(shapes.vertices_um.size() / 3);
  const auto triangles = static_cast<std::int32_t>(shapes.triangles.size() / 3);
  bool sound = shapes.cell_ranges.size() / 4 == shapes.cell_periods.size() / 3;
  for (std::size_t c = 0; c < shapes.cell_ranges.size(); c += 4) {
    const std::int32_t* const r = shapes.cell_ranges.data() + c;
    sound = sound && 0 <= r[0] && r[0] <= r[1] && r[1] <= vertices && 0 <= r[2] && r[2] <= r[3] && r[3] <= triangles;
    for (std::int32_t t = 3 * r[2]; sound && t < 3 * r[3]; ++t) {
      const std::int32_t vertex = shapes.triangles[static_cast<std::size_t>(t)];
      sound = r[0] <= vertex && vertex < r[1];
    }
  }
  if (!sound) fail(Exit::bad_input, "{}: cells, triangles and vertices do not fit each other", path.string());
  return shapes;
}

}  // namespace rouleau
