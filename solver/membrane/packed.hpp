// SPDX-License-Identifier: BSD-3-Clause
// Four doubles a vertex side by side, so that a triangle fetches a corner, or adds to it, with one instruction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "membrane/cells.hpp"

namespace rouleau {

/// x, y, z, w of one vertex: a vector and a scalar. Eight separate doubles cost a processor several times more to
/// gather than these to load, and to sum over a vertex's triangles is to add to one of these, triangle after triangle.
using Packed = double __attribute__((vector_size(32)));

/// Of vertex v, with w = 0.
inline Packed packed(const VectorArray& X, std::size_t v) { return Packed{X.x[v], X.y[v], X.z[v], 0}; }

/// Cross product of x, y, z; w is 0 where both are finite.
inline Packed cross(Packed u, Packed v) {
  const Packed v_yzx = __builtin_shufflevector(v, v, 1, 2, 0, 3), u_yzx = __builtin_shufflevector(u, u, 1, 2, 0, 3);
  const Packed zxy = u * v_yzx - u_yzx * v;
  return __builtin_shufflevector(zxy, zxy, 1, 2, 0, 3);
}

/// The same for a block of `size` vertices or triangles, as the vectorised laws want it.
struct PackedRows {
  static constexpr int size = 32;
  alignas(cache_line) double x[size], y[size], z[size], w[size];
};

/// Four by four, rows become columns.
inline void transpose(Packed& a, Packed& b, Packed& c, Packed& d) {
  const Packed ab_0 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Packed cd_0 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_0, cd_0, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_1, cd_1, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_0, cd_0, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_1, cd_1, 2, 3, 6, 7);
}

/// Sets rows [i, i + 4).
inline void set_rows(PackedRows& rows, int i, Packed a, Packed b, Packed c, Packed d) {
  transpose(a, b, c, d);
  std::memcpy(rows.x + i, &a, sizeof a);
  std::memcpy(rows.y + i, &b, sizeof b);
  std::memcpy(rows.z + i, &c, sizeof c);
  std::memcpy(rows.w + i, &d, sizeof d);
}

/// Gets rows [i, i + 4).
inline void get_rows(const PackedRows& rows, int i, Packed& a, Packed& b, Packed& c, Packed& d) {
  std::memcpy(&a, rows.x + i, sizeof a);
  std::memcpy(&b, rows.y + i, sizeof b);
  std::memcpy(&c, rows.z + i, sizeof c);
  std::memcpy(&d, rows.w + i, sizeof d);
  transpose(a, b, c, d);
}

}  // namespace rouleau
