// SPDX-License-Identifier: BSD-3-Clause
// What is conserved at a node, its equilibrium (Eq. 3 of the paper) and the source of a force (Guo), by opposite pairs.
#pragma once

#include "fluid/lattice.hpp"

namespace rouleau {

template <class Real>
using Real3 = std::array<Real, 3>;

template <class Real>
ROW_INLINE inline Real dot(const Real3<Real>& a, const Real3<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

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
template <class Real>
ROW_INLINE inline Moments<Real> moments(const Halves<Real>& f, const Real3<Real>& F) {
  Real even = f.even[0];
  unrolled<pairs - 1>([&](auto p) ROW_INLINE { even += f.even[p + 1]; });
  Moments<Real> m;
  m.rho_1 = f.rest + Real(2) * even;
  m.F = F;
  const Real one_over_rho = Real(1) / (Real(1) + m.rho_1);
  unrolled<3>([&](auto a) ROW_INLINE {
    Real odd = f.odd[a];
    unrolled<6>([&](auto i) ROW_INLINE {
      constexpr int c = c_q[1 + 2 * (3 + i)][a];
      if constexpr (c > 0) odd += f.odd[3 + i];
      if constexpr (c < 0) odd -= f.odd[3 + i];
    });
    m.j[a] = Real(2) * odd + Real(0.5) * F[a];
    m.u[a] = m.j[a] * one_over_rho;
  });
  m.even_0 = m.rho_1 - Real(1.5) * dot(m.u, m.j);
  m.u_F = dot(m.u, F);
  return m;
}

/// The values of one pair: for its first direction even + odd, for the second even - odd.
template <class Real>
struct Pair {
  Real even, odd;
};

/// f_eq - w = w [rho - 1 + 3 rho c.u + 9/2 rho (c.u)^2 - 3/2 rho u^2]   Eq. 3 of the paper, minus the weight
template <int p, class Real>
ROW_INLINE inline Pair<Real> equilibrium(const Moments<Real>& m) {
  constexpr Real w = w_q<Real>(1 + 2 * p);
  const Real c_j = along<p>(m.j);
  return {w * (m.even_0 + Real(4.5) * along<p>(m.u) * c_j), (Real(3) * w) * c_j};
}

template <class Real>
ROW_INLINE inline Real equilibrium_rest(const Moments<Real>& m) {
  return w_q<Real>(0) * m.even_0;
}

/// w [3 (c - u) + 9 (c.u) c] . F   [Guo2002 eq. 20] without its factor 1 - omega/2, which differs between even and odd
/// parts
template <int p, class Real>
ROW_INLINE inline Pair<Real> guo_source(const Moments<Real>& m) {
  constexpr Real w = w_q<Real>(1 + 2 * p);
  const Real c_F = along<p>(m.F);
  return {w * (Real(9) * along<p>(m.u) * c_F - Real(3) * m.u_F), (Real(3) * w) * c_F};
}

template <class Real>
ROW_INLINE inline Real guo_source_rest(const Moments<Real>& m) {
  return w_q<Real>(0) * (Real(-3) * m.u_F);
}

}  // namespace rouleau
