// SPDX-License-Identifier: BSD-3-Clause
// The fields of the whole lattice at every n-th node, as one process needs them to write a snapshot.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.hpp"

namespace rouleau {

/// Lattice units, single precision, x fastest.
struct LatticePicture {
  Int3 size{};                       ///< nodes that are left along x, y, z
  std::vector<float> velocity;       ///< [z][y][x][3]
  std::vector<float> rho_1;          ///< [z][y][x]  rho - 1
  std::vector<float> force;          ///< [z][y][x][3]  membrane force per volume
  std::vector<std::uint8_t> inside;  ///< [z][y][x]
};

}  // namespace rouleau
