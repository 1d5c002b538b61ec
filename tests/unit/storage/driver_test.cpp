// SPDX-License-Identifier: BSD-3-Clause
// The virtual file driver outlives every file that stands on it.
#include <gtest/gtest.h>

#include "storage/hdf5_driver.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

// HDF5 1.10 lets go of the driver before it calls the driver's close(): the last hold must not be the file's.
TEST(StorageDriver, IsThereWhenItsLastFileCloses) {
  const TemporaryDirectory directory;
  hdf5::Ground ground{posix_file_system(), {}};
  hdf5::Handle access = hdf5::access_through(ground);
  const hid_t driver = H5Pget_driver(access.id());
  hdf5::Handle file(H5Fcreate((directory.path() / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  ASSERT_GE(file.id(), 0);
  ASSERT_GE(access.close(), 0);
  ASSERT_GE(file.close(), 0);
  EXPECT_GT(H5Iis_valid(driver), 0) << "it was freed while the file was closing";
  ground.rethrow();
}

}  // namespace
}  // namespace rouleau::testing
