// SPDX-License-Identifier: BSD-3-Clause
// HDF5 on top of the file-system seam: a virtual file driver.
//
// HDF5 1.10 does not survive a file whose last writes fail: the close fails too, the file stays half open, and the
// library crashes when it is shut down. Therefore a failed write is noted here and reported to the library as done;
// whoever writes asks for the note after closing and throws the file away.
#pragma once

#include <optional>

#include "base/error.hpp"
#include "storage/file_system.hpp"
#include "storage/hdf5_handle.hpp"

namespace rouleau::hdf5 {

/// The ground an HDF5 file stands on. Must outlive the file.
struct Ground {
  FileSystem& files;
  std::optional<Error> failure;  ///< the first
  void rethrow() const {
    if (failure) throw *failure;
  }
};

/// File access properties that send every call through `ground.files`. New objects have the oldest format from `oldest`
/// on that can hold them.
[[nodiscard]] Handle access_through(Ground& ground, H5F_libver_t oldest = H5F_LIBVER_V18);

}  // namespace rouleau::hdf5
