// SPDX-License-Identifier: BSD-3-Clause
// Moving a surface: scale, rotate, translate.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau {

/// Multiplies all coordinates.
/// throws  Error (bad_input) if the factor is not positive and finite
void scale(Surface& surface, double factor);

/// Rotates about `axis` through the origin by `angle` in radians, right-handed.
/// throws  Error (bad_input) if the axis is zero or not finite
void rotate(Surface& surface, const Vec3& axis, double angle);

void translate(Surface& surface, const Vec3& shift);

}  // namespace rouleau
