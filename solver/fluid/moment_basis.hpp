// SPDX-License-Identifier: BSD-3-Clause
// The 19 orthogonal moments of D3Q19 and the rates they are known by.   [d'Humieres et al. 2002, appendix B]
#pragma once

#include "fluid/lattice.hpp"

namespace rouleau {

/// Which moments share a rate. The conserved ones (density, momentum) have none.
enum class MomentKind { conserved, e, eps, q, nu, pi, m };

struct MomentRow {
  MomentKind kind;
  std::array<int, Q> value;  ///< M_kq
};

/// Rows of M. c2 = |c|^2; e: energy, eps: its square, q: energy flux, nu: shear stress, pi: its fourth-order
/// companions, m: the third-order antisymmetric ones. e, eps, nu, pi are even in c; q, m are odd.
inline constexpr std::array<MomentRow, Q> moment_basis = [] {
  using K = MomentKind;
  std::array<MomentRow, Q> M{};
  for (int i = 0; i < Q; ++i) {
    const int x = c_q[i][0], y = c_q[i][1], z = c_q[i][2], c2 = squared_length(i);
    const int xx = 3 * x * x - c2, ww = y * y - z * z;
    const std::array<MomentRow, Q> column{{{K::conserved, {1}},
                                           {K::e, {19 * c2 - 30}},
                                           {K::eps, {(21 * c2 * c2 - 53 * c2 + 24) / 2}},
                                           {K::conserved, {x}},
                                           {K::conserved, {y}},
                                           {K::conserved, {z}},
                                           {K::q, {(5 * c2 - 9) * x}},
                                           {K::q, {(5 * c2 - 9) * y}},
                                           {K::q, {(5 * c2 - 9) * z}},
                                           {K::nu, {xx}},
                                           {K::nu, {ww}},
                                           {K::nu, {x * y}},
                                           {K::nu, {y * z}},
                                           {K::nu, {x * z}},
                                           {K::pi, {(3 * c2 - 5) * xx}},
                                           {K::pi, {(3 * c2 - 5) * ww}},
                                           {K::m, {(y * y - z * z) * x}},
                                           {K::m, {(z * z - x * x) * y}},
                                           {K::m, {(x * x - y * y) * z}}}};
    for (int k = 0; k < Q; ++k) {
      M[k].kind = column[k].kind;
      M[k].value[i] = column[k].value[0];
    }
  }
  return M;
}();

/// |M_k|^2: M^-1_qk = M_kq / |M_k|^2, since the rows are orthogonal.
inline constexpr int moment_norm(int k) {
  int sum = 0;
  for (const int v : moment_basis[k].value) sum += v * v;
  return sum;
}

inline constexpr bool is_odd(MomentKind kind) { return kind == MomentKind::q || kind == MomentKind::m; }

static_assert([] {
  for (int k = 0; k < Q; ++k)
    for (int l = 0; l < k; ++l) {
      int product = 0;
      for (int q = 0; q < Q; ++q) product += moment_basis[k].value[q] * moment_basis[l].value[q];
      if (product != 0) return false;
    }
  return true;
}());

// Each relaxed moment is purely even or purely odd, so the collision may treat the halves of the pairs apart.
static_assert([] {
  for (const MomentRow& row : moment_basis)
    for (int q = 0; q < Q; ++q)
      if (row.kind != MomentKind::conserved && row.value[opposite(q)] != (is_odd(row.kind) ? -1 : 1) * row.value[q])
        return false;
  return true;
}());

}  // namespace rouleau
