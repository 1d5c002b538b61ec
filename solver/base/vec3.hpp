// SPDX-License-Identifier: BSD-3-Clause
// Small vectors.
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/arrays.hpp"

namespace rouleau {

using Vec3 = Eigen::Vector3d;
using Int3 = std::array<int, 3>;

inline Vec3 at(const VectorArray& v, std::size_t i) { return {v.x[i], v.y[i], v.z[i]}; }
inline void set(VectorArray& v, std::size_t i, const Vec3& value) {
  v.x[i] = value[0];
  v.y[i] = value[1];
  v.z[i] = value[2];
}

}  // namespace rouleau
