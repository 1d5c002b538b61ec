// SPDX-License-Identifier: BSD-3-Clause
// Which HDF5 this is.
#pragma once

#include <string>

namespace rouleau {

/// `1.10.8`
[[nodiscard]] std::string hdf5_version();

}  // namespace rouleau
