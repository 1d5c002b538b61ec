// SPDX-License-Identifier: BSD-3-Clause
// Generated surfaces: subdivided icosahedra pressed into spheres, ellipsoids and red blood cells.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau {

inline constexpr int min_subdivisions = 0;
inline constexpr int max_subdivisions = 7;

/// Unit sphere about the origin: the icosahedron, each triangle split at its edges' midpoints `subdivisions` times and
/// projected to the sphere. 20 * 4^n triangles, 10 * 4^n + 2 vertices, counter-clockwise seen from outside.
/// Triangles are numbered depth first, vertices by their first use, so that neighbours stand close in memory.
/// throws  Error (bad_input) if `subdivisions` is outside [min_subdivisions, max_subdivisions]
Surface unit_sphere(int subdivisions);

/// Sphere about the origin.
/// throws  Error (bad_input) if the radius is not positive
Surface sphere(int subdivisions, double radius);

/// Ellipsoid about the origin, semi-axes along x, y, z.
/// throws  Error (bad_input) if a semi-axis is not positive
Surface ellipsoid(int subdivisions, const Vec3& semi_axes);

/// Red blood cell about the origin, disc axis z.   [Lehmann2020] Eqs. 14, 15
/// The sphere's vertices keep their x and y; z follows Eq. 15 with the sign that it had.
/// throws  Error (bad_input) if the radius is not positive
Surface red_blood_cell(int subdivisions, double radius);

}  // namespace rouleau
