// SPDX-License-Identifier: BSD-3-Clause
// Generated surfaces: divided icosahedra pressed into spheres, ellipsoids and red blood cells.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau {

/// How finely the icosahedron is divided: each face into n x n triangles, where n is the frequency.
class Division {
 public:
  static constexpr int max_subdivisions = 7;

  /// Each triangle split into four at its edges' midpoints, `subdivisions` times: the frequency is 2^subdivisions.
  /// throws  Error (bad_input) if `subdivisions` is outside [0, max_subdivisions]
  Division(int subdivisions);  // NOLINT(google-explicit-constructor): the usual way to say it
  /// throws  Error (bad_input) if the frequency is outside [1, 2^max_subdivisions]
  static Division of_frequency(int frequency);

  [[nodiscard]] int frequency() const { return frequency_; }

 private:
  int frequency_;
};

/// Unit sphere about the origin: the icosahedron of frequency n = p * 2^k, p odd, each face first cut into p x p
/// triangles, then each triangle split at its edges' midpoints k times, every new point projected to the sphere.
/// 20 n^2 triangles, 10 n^2 + 2 vertices, counter-clockwise seen from outside.
/// Triangles are numbered depth first, vertices by their first use, so that neighbours stand close in memory.
Surface unit_sphere(Division division);

/// Sphere about the origin.
/// throws  Error (bad_input) if the radius is not positive
Surface sphere(Division division, double radius);

/// Ellipsoid about the origin, semi-axes along x, y, z.
/// throws  Error (bad_input) if a semi-axis is not positive
Surface ellipsoid(Division division, const Vec3& semi_axes);

/// Red blood cell about the origin, disc axis z.   [Lehmann2020] Eqs. 14, 15
/// The sphere's vertices keep their x and y; z follows Eq. 15 with the sign that it had.
/// throws  Error (bad_input) if the radius is not positive
Surface red_blood_cell(Division division, double radius);

}  // namespace rouleau
