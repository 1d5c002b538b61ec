// SPDX-License-Identifier: BSD-3-Clause
// The collision of one node: two rates (TRT), or a rate for each kind of moment (MRT), with Guo's force in both.
//
// With R the relaxation operator (M^-1 S M, or omega_even / omega_odd on the halves of pairs) the paper's Eq. 4 and
// Guo's source, (1 - R/2) S_F, are together     f* = f + S_F - R (f - f_eq + S_F / 2). The bracket has no density and,
// by the definition of u, no momentum: conserved moments need no rate.
#pragma once

#include "fluid/equilibrium.hpp"
#include "fluid/moment_basis.hpp"
#include "fluid/rates.hpp"

namespace rouleau {

/// TRT: each pair by itself.   [Ginzburg 2008], force in the manner of [Guo2002]
template <class Real>
ROW_INLINE inline Halves<Real> collide(const Halves<Real>& f, const Moments<Real>& m, const TrtRates<Real>& omega) {
  Halves<Real> out;
  const Real source_rest = guo_source_rest(m);
  out.rest = f.rest + source_rest - omega.even * (f.rest - equilibrium_rest(m) + Real(0.5) * source_rest);
  unrolled<pairs>([&](auto p) ROW_INLINE {
    const Pair<Real> eq = equilibrium<p>(m);
    const Pair<Real> source = guo_source<p>(m);
    out.even[p] = f.even[p] + source.even - omega.even * (f.even[p] - eq.even + Real(0.5) * source.even);
    out.odd[p] = f.odd[p] + source.odd - omega.odd * (f.odd[p] - eq.odd + Real(0.5) * source.odd);
  });
  return out;
}

template <MomentKind kind, class Real>
ROW_INLINE inline Real rate_of(const MrtRates<Real>& s) {
  if constexpr (kind == MomentKind::e) return s.e;
  if constexpr (kind == MomentKind::eps) return s.eps;
  if constexpr (kind == MomentKind::q) return s.q;
  if constexpr (kind == MomentKind::nu) return s.nu;
  if constexpr (kind == MomentKind::pi) return s.pi;
  if constexpr (kind == MomentKind::m) return s.m;
}

/// to += factor * from, where a factor of 0 costs nothing and one of +-1 no product.
template <int factor, class Real>
ROW_INLINE inline void add_multiple(Real& to, Real from) {
  if constexpr (factor == 1)
    to += from;
  else if constexpr (factor == -1)
    to -= from;
  else if constexpr (factor != 0)
    to += Real(factor) * from;
}

/// MRT: R = M^-1 S M, row by row of M: f* -= M_k^T (s_k / |M_k|^2) (M_k r), r the bracket above.
template <class Real>
ROW_INLINE inline Halves<Real> collide(const Halves<Real>& f, const Moments<Real>& m, const MrtRates<Real>& s) {
  Halves<Real> r, out;
  const Real source_rest = guo_source_rest(m);
  r.rest = f.rest - equilibrium_rest(m) + Real(0.5) * source_rest;
  out.rest = f.rest + source_rest;
  unrolled<pairs>([&](auto p) ROW_INLINE {
    const Pair<Real> eq = equilibrium<p>(m);
    const Pair<Real> source = guo_source<p>(m);
    r.even[p] = f.even[p] - eq.even + Real(0.5) * source.even;
    r.odd[p] = f.odd[p] - eq.odd + Real(0.5) * source.odd;
    out.even[p] = f.even[p] + source.even;
    out.odd[p] = f.odd[p] + source.odd;
  });
  unrolled<Q>([&](auto k) ROW_INLINE {
    constexpr MomentRow row = moment_basis[k];
    if constexpr (row.kind != MomentKind::conserved) {
      constexpr bool odd = is_odd(row.kind);
      const std::array<Real, pairs>& half = odd ? r.odd : r.even;
      std::array<Real, pairs>& out_half = odd ? out.odd : out.even;
      Real moment = 0;
      unrolled<pairs>([&](auto p) ROW_INLINE { add_multiple<row.value[1 + 2 * p]>(moment, half[p]); });
      moment *= Real(2);  // both directions of a pair
      if constexpr (!odd) add_multiple<row.value[0]>(moment, r.rest);
      moment *= rate_of<row.kind>(s) * (Real(-1) / Real(moment_norm(k)));
      if constexpr (!odd) add_multiple<row.value[0]>(out.rest, moment);
      unrolled<pairs>([&](auto p) ROW_INLINE { add_multiple<row.value[1 + 2 * p]>(out_half[p], moment); });
    }
  });
  return out;
}

}  // namespace rouleau
