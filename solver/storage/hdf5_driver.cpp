// SPDX-License-Identifier: BSD-3-Clause
// The functions that HDF5 calls for its file access.
#include "storage/hdf5_driver.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "storage/files.hpp"

namespace rouleau::hdf5 {
namespace {

constexpr haddr_t largest_address = (haddr_t{1} << 62U) - 1;

/// The library sees the first member only.
struct DriverFile {
  H5FD_t common{};
  Ground* ground;
  File file;
  haddr_t end_of_allocation = 0;
  haddr_t end_of_file;
};

DriverFile* mine(H5FD_t* file) { return reinterpret_cast<DriverFile*>(file); }
const DriverFile* mine(const H5FD_t* file) { return reinterpret_cast<const DriverFile*>(file); }

/// Runs `work`; keeps its error, since no exception may pass through the library. Returns whether it went well.
template <class Work>
bool keep_failure(Ground& ground, const Work& work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    if (!ground.failure) ground.failure = error;
    return false;
  }
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t access, haddr_t) {
  Ground* ground = *static_cast<Ground* const*>(H5Pget_driver_info(access));
  std::unique_ptr<DriverFile> opened;
  keep_failure(*ground, [&] {
    File file = (flags & H5F_ACC_TRUNC) != 0  ? File::overwrite(ground->files, name)
                : (flags & H5F_ACC_RDWR) != 0 ? File::update(ground->files, name)
                                              : File::read(ground->files, name);
    const haddr_t length = file_size(ground->files, name);
    opened = std::make_unique<DriverFile>(DriverFile{{}, ground, std::move(file), 0, length});
  });
  return opened ? &opened.release()->common : nullptr;
}

herr_t close_file(H5FD_t* file) {
  const std::unique_ptr<DriverFile> closing(mine(file));
  keep_failure(*closing->ground, [&] { closing->file.close(); });
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA |
           H5FD_FEAT_DATA_SIEVE;
  return 0;
}

haddr_t get_end_of_allocation(const H5FD_t* file, H5FD_mem_t) { return mine(file)->end_of_allocation; }

herr_t set_end_of_allocation(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  mine(file)->end_of_allocation = address;
  return 0;
}

haddr_t get_end_of_file(const H5FD_t* file, H5FD_mem_t) { return mine(file)->end_of_file; }

herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  const DriverFile& source = *mine(file);
  const bool done = keep_failure(*source.ground, [&] {
    const std::size_t have = source.file.read_at(address, buffer, size, Exit::bad_input);
    // The library reads ahead of what it has written yet, and expects zeros there.
    std::memset(static_cast<char*>(buffer) + have, 0, size - have);
  });
  return done ? 0 : -1;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
  DriverFile& target = *mine(file);
  keep_failure(*target.ground,
               [&] { target.file.write_at(address, std::string_view(static_cast<const char*>(buffer), size)); });
  target.end_of_file = std::max<haddr_t>(target.end_of_file, address + size);
  return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  DriverFile& target = *mine(file);
  if (target.end_of_file == target.end_of_allocation) return 0;
  keep_failure(*target.ground, [&] { target.file.truncate(target.end_of_allocation); });
  target.end_of_file = target.end_of_allocation;
  return 0;
}

H5FD_class_t driver() {
  H5FD_class_t functions{};
  functions.name = "rouleau";
  functions.maxaddr = largest_address;
  functions.fc_degree = H5F_CLOSE_STRONG;
  functions.fapl_size = sizeof(Ground*);
  functions.open = open_file;
  functions.close = close_file;
  functions.query = query;
  functions.get_eoa = get_end_of_allocation;
  functions.set_eoa = set_end_of_allocation;
  functions.get_eof = get_end_of_file;
  functions.read = read_bytes;
  functions.write = write_bytes;
  functions.truncate = truncate_file;
  const H5FD_mem_t metadata_and_data[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(metadata_and_data), std::end(metadata_and_data), functions.fl_map);
  return functions;
}

}  // namespace

Handle access_through(Ground& ground, H5F_libver_t oldest) {
  // Registered for as long as the process lives: when a file closes, HDF5 1.10 lets go of its driver first and then
  // calls the driver's close(), which crashes now and then if nobody else holds the driver.
  static const hid_t registered = [] {
    const H5FD_class_t functions = driver();
    return H5FDregister(&functions);
  }();
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  Ground* info = &ground;
  require(H5Pset_driver(access.id(), registered, &info) >= 0, "the HDF5 library refuses our file driver");
  H5Pset_libver_bounds(access.id(), oldest, H5F_LIBVER_V110);
  return access;
}

}  // namespace rouleau::hdf5
