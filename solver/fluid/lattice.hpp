// SPDX-License-Identifier: BSD-3-Clause
// The D3Q19 lattice: velocities, weights, opposites, and the moment identities that the method rests on.
//
//   q = 0 rest;  q = 1 + 2p and 2 + 2p are the opposite velocities +c and -c of pair p:
//
//     p   0     1     2     3      4      5      6      7      8             z  y
//     c  +x    +y    +z   +x+y   +x-y   +x+z   +x-z   +y+z   +y-z            | /
//     q  1 2   3 4   5 6   7 8   9 10  11 12  13 14  15 16  17 18            o-- x
//
//   weights: 1/3 at rest, 1/18 along an axis, 1/36 along a face diagonal; speed of sound^2 = 1/3.
#pragma once

#include <array>

#include "base/simd.hpp"

namespace rouleau {

inline constexpr int Q = 19;
inline constexpr int pairs = 9;

/// c_q, nodes a step.
inline constexpr std::array<std::array<int, 3>, Q> c_q = [] {
  constexpr std::array<std::array<int, 3>, pairs> plus{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}};
  std::array<std::array<int, 3>, Q> c{};
  for (int p = 0; p < pairs; ++p)
    for (int a = 0; a < 3; ++a) {
      c[1 + 2 * p][a] = plus[p][a];
      c[2 + 2 * p][a] = -plus[p][a];
    }
  return c;
}();

inline constexpr int squared_length(int q) {
  return c_q[q][0] * c_q[q][0] + c_q[q][1] * c_q[q][1] + c_q[q][2] * c_q[q][2];
}

/// 36 w_q: whole numbers, for exact identities.
inline constexpr int weight_36(int q) { return squared_length(q) == 0 ? 12 : squared_length(q) == 1 ? 2 : 1; }

/// w_q.
template <class Real = double>
constexpr Real w_q(int q) {
  return Real(weight_36(q)) / Real(36);
}

inline constexpr int opposite(int q) { return q == 0 ? 0 : (q % 2 == 1 ? q + 1 : q - 1); }

/// Side of a face: 0 the low end of an axis, 1 the high one.
inline constexpr int direction_sign(int side) { return side == 0 ? -1 : 1; }

/// The five directions that leave a block through its face, c_q[axis] = -1 (side 0) or +1 (side 1): what a neighbour
/// needs.
inline constexpr std::array<int, 5> directions_out(int axis, int side) {
  std::array<int, 5> list{};
  int n = 0;
  for (int q = 0; q < Q; ++q)
    if (c_q[q][axis] == direction_sign(side)) list[n++] = q;
  return list;
}

/// c_p . v of the first direction of pair p, without a product by 0 or 1.
template <int p, class Real>
ROW_INLINE inline Real along(const std::array<Real, 3>& v) {
  constexpr auto c = c_q[1 + 2 * p];
  constexpr int a = c[0] != 0 ? 0 : (c[1] != 0 ? 1 : 2);
  if constexpr (p < 3) {
    return v[a];
  } else {
    constexpr int b = c[2] != 0 ? 2 : 1;
    if constexpr (c[b] > 0)
      return v[a] + v[b];
    else
      return v[a] - v[b];
  }
}

namespace lattice_identities {

constexpr int sum36(auto&& term) {
  int s = 0;
  for (int q = 0; q < Q; ++q) s += weight_36(q) * term(q);
  return s;
}

constexpr bool hold() {
  const auto delta = [](int a, int b) { return a == b ? 1 : 0; };
  if (sum36([](int) { return 1; }) != 36) return false;
  for (int q = 0; q < Q; ++q)
    for (int a = 0; a < 3; ++a)
      if (c_q[opposite(q)][a] != -c_q[q][a]) return false;
  for (int a = 0; a < 3; ++a) {
    if (sum36([&](int q) { return c_q[q][a]; }) != 0) return false;
    for (int b = 0; b < 3; ++b) {
      if (sum36([&](int q) { return c_q[q][a] * c_q[q][b]; }) != 12 * delta(a, b)) return false;
      for (int g = 0; g < 3; ++g) {
        if (sum36([&](int q) { return c_q[q][a] * c_q[q][b] * c_q[q][g]; }) != 0) return false;
        for (int d = 0; d < 3; ++d) {
          const int isotropic = 4 * (delta(a, b) * delta(g, d) + delta(a, g) * delta(b, d) + delta(a, d) * delta(b, g));
          if (sum36([&](int q) { return c_q[q][a] * c_q[q][b] * c_q[q][g] * c_q[q][d]; }) != isotropic) return false;
        }
      }
    }
  }
  return true;
}

// sum w = 1, sum w c = 0, sum w c c = 1/3, sum w c c c = 0, sum w c c c c = 1/9 (dd + dd + dd); opposites are opposite.
static_assert(hold());

}  // namespace lattice_identities

}  // namespace rouleau
