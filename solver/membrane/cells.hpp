// SPDX-License-Identifier: BSD-3-Clause
// The membranes of all cells of a run: topology, reference state, moving state. Every rank holds all of it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/arrays.hpp"
#include "base/vec3.hpp"

namespace rouleau {

/// Vertex indices of each triangle, counter-clockwise seen from outside.
struct Triangles {
  Array<std::int32_t> a, b, c;
  [[nodiscard]] std::size_t size() const { return a.size(); }
};

/// A closed surface by itself, as read from a file or generated.
struct Surface {
  VectorArray X;        ///< [vertices]
  Triangles triangles;  ///< [triangles]
};

/// Which part of the arrays belongs to one cell, and what it keeps.
struct CellRange {
  std::int32_t vertex_begin = 0, vertex_end = 0;
  std::int32_t triangle_begin = 0, triangle_end = 0;
  double volume_0 = 0;  ///< V0 that the volume shift restores
  double area_0 = 0;
};

/// For each vertex the triangles around it: entries [begin[v], begin[v + 1]) of triangle (index) and corner (0, 1, 2),
/// in ascending triangle order. Sums over a vertex's triangles run in this order, whatever the number of ranks.
struct VertexTriangles {
  Array<std::int32_t> begin, triangle, corner;
};

/// How a membrane resists strain in its plane (skalak.hpp, neo_hookean.hpp).
enum class InPlaneLaw { skalak, neo_hookean };

/// Moduli in lattice units, in the [Krueger] convention: Skalak's W = kappa_S / 12 (I1^2 + 2 I1 - 2 I2)
/// + kappa_A / 12 I2^2. Of both laws G_s = kappa_S / 3.
struct Moduli {
  double kappa_S = 0;
  double kappa_A = 0;  ///< C kappa_S; the neo-Hookean law has none
  double kappa_B = 0;  ///< Helfrich E = 2 kappa_B int H^2 dS
  InPlaneLaw law = InPlaneLaw::skalak;
};

/// All cells, arrays concatenated cell after cell.
struct Cells {
  Triangles triangles;      ///< indices into the concatenated vertices
  VertexTriangles around;   ///< topology seen from the vertices
  VectorArray X_reference;  ///< stress-free shape
  VectorArray X;            ///< positions, lattice units; a cell is never cut: X may lie up to one period outside
  VectorArray U;            ///< velocities of this step
  VectorArray U_previous;   ///< of the step before (second-order Adams-Bashforth)
  VectorArray F;            ///< membrane forces on the fluid
  std::vector<CellRange> ranges;
  std::vector<Int3> images;  ///< periods a cell was moved back along each axis: unwrapped x = X + images * period

  [[nodiscard]] std::size_t vertices() const { return X.size(); }
};

}  // namespace rouleau
