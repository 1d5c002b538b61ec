// SPDX-License-Identifier: BSD-3-Clause
#include "parallel/version.hpp"

#include <mpi.h>

#include <array>

namespace rouleau {

std::string mpi_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string whole(text.data());
  return whole.substr(0, whole.find(','));
}

}  // namespace rouleau
