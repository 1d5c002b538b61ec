// SPDX-License-Identifier: BSD-3-Clause
// An array of an HDF5 file, read by the library alone: what any other program would see.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace rouleau::testing {

template <class T>
struct Hdf5Array {
  std::vector<hsize_t> shape;
  std::vector<T> values;
};

/// Converts to T whatever is stored.
template <class T>
Hdf5Array<T> hdf5_array(const std::filesystem::path& path, const std::string& name) {
  Hdf5Array<T> array;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_GE(file, 0) << path;
  const hid_t data = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  EXPECT_GE(data, 0) << name;
  if (data >= 0) {
    const hid_t space = H5Dget_space(data);
    array.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, array.shape.data(), nullptr);
    array.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    const hid_t type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT;
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, int>);
    EXPECT_GE(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()), 0) << name;
    H5Sclose(space);
    H5Dclose(data);
  }
  H5Fclose(file);
  return array;
}

}  // namespace rouleau::testing
