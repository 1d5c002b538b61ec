// SPDX-License-Identifier: BSD-3-Clause
// Which build this is.
#pragma once

#include <string>

namespace rouleau {

const char* version();   ///< `0.1.0`
const char* git_hash();  ///< of the commit built, with `-dirty` if the tree differed from it; `unknown` outside a clone

/// The answer to --version, several lines, ended. The versions of HDF5 and MPI come from the folders that may ask for
/// them.
std::string version_text(const std::string& hdf5_version, const std::string& mpi_version);

}  // namespace rouleau
