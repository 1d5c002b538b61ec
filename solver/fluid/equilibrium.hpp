// SPDX-License-Identifier: BSD-3-Clause
// What is conserved at a node, its equilibrium (Eq. 3 of the paper) and the source of a force (Guo), by opposite pairs.
#pragma once

#include "base/pack.hpp"
#include "fluid/lattice.hpp"

namespace rouleau {

template <class Real>
using Real3 = std::array<Real, 3>;

template <class Real>
ROW_INLINE inline Real dot(const Real3<Real>& a, const Real3<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// T stands for a number of one node, or for a pack of them, one a node.

/// The populations of a node minus their weights as sums and differences of opposite pairs p.
template <class T>
struct Pulled {
  T rest;
  std::array<T, pairs> sum, difference;
};

/// The populations of a node minus their weights, as halves of opposite pairs p: f_q - w_q = even[p] + odd[p] for the
/// first direction of the pair, even[p] - odd[p] for the second. Also holds whatever else has one value a direction.
template <class Real>
struct Halves {
  Real rest;
  std::array<Real, pairs> even, odd;
};

/// Of one node, force included.
template <class Real>
struct Moments {
  Real rho_1;     ///< rho - 1
  Real3<Real> F;  ///< force density
  Real3<Real> j;  ///< rho u
  Real3<Real> u;  ///< velocity
  Real even_0;    ///< rho - 1 - 3/2 rho u^2
  Real u_F;       ///< u . F
};

/// rho = 1 + sum f_q;  rho u = sum c_q f_q + F/2   [Guo2002 eq. 19]; f stands for f_q - w_q
template <class T>
ROW_INLINE inline Moments<T> moments(const Pulled<T>& f, const Real3<T>& F) {
  using E = Element<T>;
  const auto& s = f.sum;
  const auto& d = f.difference;
  Moments<T> m;
  m.rho_1 = (((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]))) + (s[8] + f.rest);
  m.F = F;
  m.j[0] = fused(broadcast<T>(E(0.5)), F[0], (d[0] + (d[3] + d[4])) + (d[5] + d[6]));
  m.j[1] = fused(broadcast<T>(E(0.5)), F[1], (d[1] + (d[3] - d[4])) + (d[7] + d[8]));
  m.j[2] = fused(broadcast<T>(E(0.5)), F[2], (d[2] + (d[5] - d[6])) + (d[7] - d[8]));
  const T one_over_rho = E(1) / (E(1) + m.rho_1);
  unrolled<3>([&](auto a) ROW_INLINE { m.u[a] = m.j[a] * one_over_rho; });
  m.even_0 = m.rho_1 - E(1.5) * dot(m.u, m.j);
  m.u_F = dot(m.u, F);
  return m;
}

/// The values of one pair: for its first direction even + odd, for the second even - odd.
template <class T>
struct Pair {
  T even, odd;
};

/// f_eq - w = w [rho - 1 + 3 rho c.u + 9/2 rho (c.u)^2 - 3/2 rho u^2]   Eq. 3 of the paper, minus the weight
template <int p, class T>
ROW_INLINE inline Pair<T> equilibrium(const Moments<T>& m) {
  using E = Element<T>;
  constexpr E w = w_q<E>(1 + 2 * p);
  const T c_j = along<p>(m.j);
  return {w * (m.even_0 + E(4.5) * along<p>(m.u) * c_j), (E(3) * w) * c_j};
}

template <class T>
ROW_INLINE inline T equilibrium_rest(const Moments<T>& m) {
  return w_q<Element<T>>(0) * m.even_0;
}

/// w [3 (c - u) + 9 (c.u) c] . F   [Guo2002 eq. 20] without its factor 1 - omega/2, which differs between even and odd
/// parts
template <int p, class T>
ROW_INLINE inline Pair<T> guo_source(const Moments<T>& m) {
  using E = Element<T>;
  constexpr E w = w_q<E>(1 + 2 * p);
  const T c_F = along<p>(m.F);
  return {w * (E(9) * along<p>(m.u) * c_F - E(3) * m.u_F), (E(3) * w) * c_F};
}

template <class T>
ROW_INLINE inline T guo_source_rest(const Moments<T>& m) {
  return w_q<Element<T>>(0) * (Element<T>(-3) * m.u_F);
}

}  // namespace rouleau
