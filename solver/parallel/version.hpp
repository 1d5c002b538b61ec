// SPDX-License-Identifier: BSD-3-Clause
// Which MPI this is.
#pragma once

#include <string>

namespace rouleau {

/// `Open MPI v4.1.4`; may be asked before MPI is started.
std::string mpi_version();

}  // namespace rouleau
