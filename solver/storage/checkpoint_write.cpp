// SPDX-License-Identifier: BSD-3-Clause
// Laying out and filling the HDF5 file of a checkpoint.
#include "storage/checkpoint_write.hpp"

#include <array>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "parallel/slabs.hpp"
#include "storage/checkpoint_file.hpp"
#include "storage/checksum.hpp"
#include "storage/hdf5_driver.hpp"
#include "storage/hdf5_handle.hpp"
#include "storage/seal.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

using hdf5::check;
using hdf5::Handle;

/// Makes the groups along an item's path. Times are not kept, so that equal states give equal files.
void make_groups(const Handle& file, const std::string& name, const std::string& path) {
  const Handle create(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(create.id(), false);
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    const std::string group = name.substr(0, slash);
    if (H5Lexists(file.id(), group.c_str(), H5P_DEFAULT) > 0) continue;
    const Handle made(
        check(H5Gcreate2(file.id(), group.c_str(), H5P_DEFAULT, create.id(), H5P_DEFAULT), path, group, Exit::io),
        H5Gclose);
  }
}

Handle make_dataset(const Handle& file, const std::string& name, hid_t type, const Handle& space,
                    const std::string& path) {
  make_groups(file, name, path);
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(create.id(), false);
  H5Pset_layout(create.id(), H5D_CONTIGUOUS);
  H5Pset_alloc_time(create.id(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(create.id(), H5D_FILL_TIME_NEVER);
  return {check(H5Dcreate2(file.id(), name.c_str(), type, space.id(), H5P_DEFAULT, create.id(), H5P_DEFAULT), path,
                name, Exit::io),
          H5Dclose};
}

void close(Handle handle, const std::string& path, const std::string& what) {
  check(handle.close(), path, what, Exit::io);
}

void write_text(const Handle& file, const char* name, const std::string& text, const std::string& path) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), text.size());
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  Handle data = make_dataset(file, name, type.id(), space, path);
  check(H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path, name, Exit::io);
  close(std::move(data), path, name);
}

void write_replicated(const Handle& file, const ReplicatedItem& item, const std::string& path) {
  const std::vector<hsize_t> shape(item.shape.begin(), item.shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const hid_t type = hdf5::element_type(item.type);
  Handle data = make_dataset(file, item.name, type, space, path);
  if (element_count(item) > 0) {
    check(H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, item.data), path, item.name, Exit::io);
  }
  close(std::move(data), path, item.name);
}

/// Returns where in the file the values go.
std::uint64_t place_lattice_item(const Handle& file, const LatticeItem& item, const Int3& n, const std::string& path) {
  const std::array<hsize_t, 4> shape{item.data.size(), static_cast<hsize_t>(n[2]), static_cast<hsize_t>(n[1]),
                                     static_cast<hsize_t>(n[0])};
  const Handle space(H5Screate_simple(4, shape.data(), nullptr), H5Sclose);
  Handle data = make_dataset(file, item.name, hdf5::element_type(item.type), space, path);
  const haddr_t place = H5Dget_offset(data.id());
  if (place == HADDR_UNDEF) fail(Exit::io, "{}: the HDF5 library gave {} no place in the file", path, item.name);
  close(std::move(data), path, item.name);
  return place;
}

void pack(const LatticeItem& item, std::size_t component, const Block& block, std::vector<std::byte>& packed) {
  const std::size_t size = element_size(item.type);
  const std::size_t row = static_cast<std::size_t>(block.size[0]) * size;
  packed.resize(node_count(block) * size);
  const auto* bytes = static_cast<const std::byte*>(item.data[component]);
  std::byte* to = packed.data();
  for (int k = 0; k < block.size[2]; ++k) {
    for (int j = 0; j < block.size[1]; ++j, to += row) {
      std::memcpy(to, bytes + static_cast<std::size_t>(item.layout.index(0, j, k)) * size, row);
    }
  }
}

}  // namespace

std::vector<std::uint64_t> lay_out_checkpoint(FileSystem& files, const fs::path& path, const PersistentState& state,
                                              const CheckpointTexts& texts) {
  hdf5::silence();
  const std::string name = path.string();
  hdf5::Ground ground{files, {}};
  const Handle access = hdf5::access_through(ground);
  const Handle create(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(create.id(), seal_bytes);
  H5Pset_obj_track_times(create.id(), false);
  const hid_t created = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, create.id(), access.id());
  ground.rethrow();
  Handle file(check(created, name, "creating", Exit::io), H5Fclose);
  write_text(file, "metadata", texts.metadata, name);
  write_text(file, "manifest", texts.manifest, name);
  write_text(file, "manifest_checksum", hex(text_checksum(texts.manifest)), name);
  for (const ReplicatedItem& item : state.replicated_items) write_replicated(file, item, name);
  std::vector<std::uint64_t> places;
  for (const LatticeItem& item : state.lattice_items) {
    places.push_back(place_lattice_item(file, item, state.lattice.size, name));
  }
  close(std::move(file), name, "closing");
  ground.rethrow();

  File reserve = File::update(files, path);
  reserve.allocate(file_size(files, path));
  reserve.sync();
  reserve.close();
  return places;
}

void write_lattice_items(FileSystem& files, const fs::path& path, const Communicator& comm,
                         const PersistentState& state, const std::vector<std::uint64_t>& places) {
  std::optional<File> file;
  comm.all_agree([&] { file.emplace(File::update(files, path)); });
  Slabs slabs(comm, state.lattice, state.block);
  const auto plane =
      static_cast<std::uint64_t>(state.lattice.size[0]) * static_cast<std::uint64_t>(state.lattice.size[1]);
  std::vector<std::byte> packed;
  std::vector<std::byte> slab;
  std::optional<Error> failure;
  for (std::size_t i = 0; i < state.lattice_items.size(); ++i) {
    const LatticeItem& item = state.lattice_items[i];
    const std::uint64_t component_bytes = static_cast<std::uint64_t>(state.lattice.nodes()) * element_size(item.type);
    const std::uint64_t slab_begin = static_cast<std::uint64_t>(slabs.first_plane()) * plane * element_size(item.type);
    for (std::size_t c = 0; c < item.data.size(); ++c) {
      pack(item, c, state.block, packed);
      slabs.gather(packed, element_size(item.type), slab);
      // A rank whose writes have failed goes on taking part in the exchange; the error is everybody's at the end.
      if (failure) continue;
      try {
        file->write_at(places[i] + c * component_bytes + slab_begin,
                       std::string_view(reinterpret_cast<const char*>(slab.data()), slab.size()));
      } catch (const Error& error) {
        failure = error;
      }
    }
  }
  comm.all_agree([&] {
    if (failure) throw *failure;
    file->sync();
    file->close();
  });
}

}  // namespace rouleau
