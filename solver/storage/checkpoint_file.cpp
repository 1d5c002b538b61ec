// SPDX-License-Identifier: BSD-3-Clause
// Reading a checkpoint file through HDF5.
#include "storage/checkpoint_file.hpp"

#include <algorithm>
#include <array>

#include "storage/checksum.hpp"
#include "storage/files.hpp"

namespace rouleau {
namespace {

constexpr std::uint64_t longest_text = 64U << 20U;  // bytes; metadata and manifest are some 10 KB

}  // namespace

std::size_t node_count(const Block& block) {
  return static_cast<std::size_t>(block.size[0]) * static_cast<std::size_t>(block.size[1]) *
         static_cast<std::size_t>(block.size[2]);
}

/// What the file system said counts for more than what the library made of it.
template <class T>
T CheckpointFile::check(T value, const std::string& what) const {
  ground_->rethrow();
  return hdf5::check(value, name_, what, Exit::bad_input);
}

CheckpointFile::CheckpointFile(FileSystem& files, const std::filesystem::path& path)
    : name_(path.string()), ground_(std::make_unique<hdf5::Ground>(hdf5::Ground{files, {}})) {
  hdf5::silence();
  const hdf5::Handle access = hdf5::access_through(*ground_);
  file_ = {check(H5Fopen(name_.c_str(), H5F_ACC_RDONLY, access.id()), "opening"), H5Fclose};
  const std::string manifest = read_text("manifest", longest_text);
  if (read_text("manifest_checksum", 16) != hex(text_checksum(manifest))) {
    fail(Exit::bad_input, "{}: the manifest does not match its checksum", name_);
  }
  manifest_ = manifest_from_json(manifest, name_);
  const std::string metadata = read_text("metadata", longest_text);
  metadata_ = metadata_from_json(metadata, name_);
  if (manifest_.layout != metadata_.layout) {
    fail(Exit::bad_input, "{}: layout version {} in the manifest, {} in the metadata", name_, manifest_.layout,
         metadata_.layout);
  }
  if (!readable()) return;
  if (manifest_.metadata_checksum != text_checksum(metadata)) {
    fail(Exit::bad_input, "{}: the metadata does not match its checksum", name_);
  }
  // Before anybody makes room for the values: that much is really there, in that shape.
  const std::uint64_t length = file_size(files, path);
  for (const ManifestItem& item : manifest_.items) {
    if (item_bytes(item, name_) > length) {
      fail(Exit::bad_input, "{}: the manifest gives {} {} bytes, the file has {}", name_, item.name,
           item_bytes(item, name_), length);
    }
    static_cast<void>(open_dataset(item));
  }
}

const ManifestItem* CheckpointFile::find(const std::string& name) const {
  const auto found = std::find_if(manifest_.items.begin(), manifest_.items.end(),
                                  [&](const ManifestItem& item) { return item.name == name; });
  return found == manifest_.items.end() ? nullptr : &*found;
}

std::string CheckpointFile::read_text(const char* name, std::uint64_t longest) const {
  const hdf5::Handle data(check(H5Dopen2(file_.id(), name, H5P_DEFAULT), name), H5Dclose);
  const hdf5::Handle type(H5Dget_type(data.id()), H5Tclose);
  const hdf5::Handle space(H5Dget_space(data.id()), H5Sclose);
  const bool text = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0 &&
                    H5Sget_simple_extent_type(space.id()) == H5S_SCALAR;
  const std::uint64_t length = text ? H5Tget_size(type.id()) : 0;
  if (length == 0 || length > longest) {
    fail(Exit::bad_input, "{}: `{}` is not a text of 1 to {} bytes", name_, name, longest);
  }
  std::string content(length, '\0');
  check(H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data()), name);
  return content;
}

hdf5::Handle CheckpointFile::open_dataset(const ManifestItem& item) const {
  hdf5::Handle data(check(H5Dopen2(file_.id(), item.name.c_str(), H5P_DEFAULT), item.name), H5Dclose);
  const hdf5::Handle type(H5Dget_type(data.id()), H5Tclose);
  const hdf5::Handle space(H5Dget_space(data.id()), H5Sclose);
  std::vector<hsize_t> shape(item.shape.size());
  const bool same = H5Tequal(type.id(), hdf5::element_type(item.type)) > 0 &&
                    H5Sget_simple_extent_ndims(space.id()) == static_cast<int>(shape.size()) &&
                    H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) >= 0 &&
                    std::equal(shape.begin(), shape.end(), item.shape.begin());
  if (!same) fail(Exit::bad_input, "{}: type or shape of {} is not that of the manifest", name_, item.name);
  return data;
}

void CheckpointFile::read_block(const ManifestItem& item, std::size_t component, const Block& block,
                                void* packed) const {
  const hdf5::Handle data = open_dataset(item);
  if (node_count(block) == 0) return;
  const hdf5::Handle space(H5Dget_space(data.id()), H5Sclose);
  const std::array<hsize_t, 4> start{component, static_cast<hsize_t>(block.begin[2]),
                                     static_cast<hsize_t>(block.begin[1]), static_cast<hsize_t>(block.begin[0])};
  const std::array<hsize_t, 4> count{1, static_cast<hsize_t>(block.size[2]), static_cast<hsize_t>(block.size[1]),
                                     static_cast<hsize_t>(block.size[0])};
  const hdf5::Handle memory(H5Screate_simple(4, count.data(), nullptr), H5Sclose);
  check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), item.name);
  check(H5Dread(data.id(), hdf5::element_type(item.type), memory.id(), space.id(), H5P_DEFAULT, packed), item.name);
}

void CheckpointFile::read_all(const ManifestItem& item, void* values) const {
  const hdf5::Handle data = open_dataset(item);
  if (item_bytes(item, name_) == 0) return;
  check(H5Dread(data.id(), hdf5::element_type(item.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), item.name);
}

}  // namespace rouleau
