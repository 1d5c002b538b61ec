// SPDX-License-Identifier: BSD-3-Clause
// Cells of any number of triangles, for sweeps in which that number grows as N^2.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau::speed {

/// A red blood cell about `centre`, disc axis z. Each face of the icosahedron is cut into `frequency`^2 triangles: 20
/// f^2 triangles and 10 f^2 + 2 vertices in all, numbered along a space-filling curve. frequency = 16 has the paper's
/// 5120.
Surface red_blood_cell_of_frequency(int frequency, double radius, const Vec3& centre);

}  // namespace rouleau::speed
