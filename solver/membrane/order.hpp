// SPDX-License-Identifier: BSD-3-Clause
// Numbering a loaded mesh along a space-filling curve, so that neighbours stand close in memory.
#pragma once

#include "membrane/cells.hpp"

namespace rouleau {

/// New numbering: new triangle t is the old triangle `triangle[t]`, new vertex v the old vertex `vertex[v]`.
struct MeshOrder {
  Array<std::int32_t> triangle, vertex;
};

/// Triangles along a Z-order curve through their centres (ties by the old number), vertices by their first use.
/// Generated shapes need no reordering. The surface must be one that check_surface accepts.
MeshOrder space_curve_order(const Surface& surface);

/// The same surface in the new numbering; a shape and its reference take the same order.
Surface reordered(const Surface& surface, const MeshOrder& order);

}  // namespace rouleau
