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

/// The numbers that TRT multiplies with, made of its rates omega_e, omega_o once.
template <class T>
struct TrtFactors {
  T keep_even, keep_odd;  ///< (1 - omega)/2
  T v_j, v_F;             ///< omega_e/2, 1 - omega_e/2
  T m_j, m_F;             ///< omega_o/12, (1 - omega_o/2)/12
};

template <class Real>
TrtFactors<Real> factors_of(const TrtRates<>& omega) {
  const double e = omega.even, o = omega.odd;
  return {Real((1 - e) / 2), Real((1 - o) / 2), Real(e / 2), Real(1 - e / 2), Real(o / 12), Real((1 - o / 2) / 12)};
}

/// TRT: each pair by itself.   [Ginzburg 2008], force in the manner of [Guo2002]
///
/// Equilibrium and source share their form: with v = omega_e/2 j + (1 - omega_e/2) F and m = omega_o j + (1 -
/// omega_o/2) F, what is added to the even half of a pair is w [omega_e (rho - 1) - 3 u.v + 9 (c.u)(c.v)], to the odd
/// half 3 w c.m. (rho is 1 + rho_1, j = rho u, so that u_a j_b = u_b j_a.)
template <class T>
ROW_INLINE inline Halves<T> collide(const Pulled<T>& f, const Moments<T>& n, const TrtFactors<T>& k) {
  using E = Element<T>;
  const T quarter = broadcast<T>(E(0.25)), half = broadcast<T>(E(0.5));
  Real3<T> v, m, uv;  // m is over 12
  unrolled<3>([&](auto a) ROW_INLINE {
    v[a] = fused(k.v_F, n.F[a], k.v_j * n.j[a]);
    m[a] = fused(k.m_F, n.F[a], k.m_j * n.j[a]);
    uv[a] = n.u[a] * v[a];
  });
  // [omega_e (rho - 1) - 3 u.v] / 36
  const T isotropic = fused(broadcast<T>(E(-1) / E(12)), uv[0] + uv[1] + uv[2], (E(1) / E(18)) * k.v_j * n.rho_1);
  const T isotropic_axis = isotropic + isotropic;

  Halves<T> added, out;
  unrolled<3>([&](auto a) ROW_INLINE {
    added.even[a] = fused(half, uv[a], isotropic_axis);
    added.odd[a] = m[a] + m[a];
  });
  unrolled<3>([&](auto plane) ROW_INLINE {  // xy, xz, yz
    constexpr int a = plane < 2 ? 0 : 1, b = plane == 0 ? 1 : 2, p = 3 + 2 * plane;
    const T along_both = fused(quarter, uv[a] + uv[b], isotropic);
    const T across = fused(n.u[a], v[b], n.u[b] * v[a]);
    added.even[p] = fused(quarter, across, along_both);
    added.even[p + 1] = fused(-quarter, across, along_both);
    added.odd[p] = m[a] + m[b];
    added.odd[p + 1] = m[a] - m[b];
  });
  out.rest = fused(k.keep_even + k.keep_even, f.rest, E(12) * isotropic);
  unrolled<pairs>([&](auto p) ROW_INLINE {
    out.even[p] = fused(k.keep_even, f.sum[p], added.even[p]);
    out.odd[p] = fused(k.keep_odd, f.difference[p], added.odd[p]);
  });
  return out;
}

template <MomentKind kind, class T>
ROW_INLINE inline T rate_of(const MrtRates<T>& s) {
  if constexpr (kind == MomentKind::e) return s.e;
  if constexpr (kind == MomentKind::eps) return s.eps;
  if constexpr (kind == MomentKind::q) return s.q;
  if constexpr (kind == MomentKind::nu) return s.nu;
  if constexpr (kind == MomentKind::pi) return s.pi;
  if constexpr (kind == MomentKind::m) return s.m;
}

/// to += factor * from, where a factor of 0 costs nothing and one of +-1 no product.
template <int factor, class T>
ROW_INLINE inline void add_multiple(T& to, const T& from) {
  if constexpr (factor == 1)
    to += from;
  else if constexpr (factor == -1)
    to -= from;
  else if constexpr (factor != 0)
    to = fused(broadcast<T>(Element<T>(factor)), from, to);
}

/// MRT: R = M^-1 S M, row by row of M: f* -= M_k^T (s_k / |M_k|^2) (M_k r), r the bracket above.
template <class T>
ROW_INLINE inline Halves<T> collide(const Pulled<T>& f, const Moments<T>& m, const MrtRates<T>& s) {
  using E = Element<T>;
  const T half = broadcast<T>(E(0.5));
  Halves<T> r, out;
  const T source_rest = guo_source_rest(m);
  r.rest = f.rest - equilibrium_rest(m) + half * source_rest;
  out.rest = f.rest + source_rest;
  unrolled<pairs>([&](auto p) ROW_INLINE {
    const Pair<T> eq = equilibrium<p>(m);
    const Pair<T> source = guo_source<p>(m);
    r.even[p] = fused(half, f.sum[p] + source.even, -eq.even);
    r.odd[p] = fused(half, f.difference[p] + source.odd, -eq.odd);
    out.even[p] = fused(half, f.sum[p], source.even);
    out.odd[p] = fused(half, f.difference[p], source.odd);
  });
  unrolled<Q>([&](auto k) ROW_INLINE {
    constexpr MomentRow row = moment_basis[k];
    if constexpr (row.kind != MomentKind::conserved) {
      constexpr bool odd = is_odd(row.kind);
      const std::array<T, pairs>& r_half = odd ? r.odd : r.even;
      std::array<T, pairs>& out_half = odd ? out.odd : out.even;
      T moment{};
      unrolled<pairs>([&](auto p) ROW_INLINE { add_multiple<row.value[1 + 2 * p]>(moment, r_half[p]); });
      moment *= E(2);  // both directions of a pair
      if constexpr (!odd) add_multiple<row.value[0]>(moment, r.rest);
      moment *= rate_of<row.kind>(s) * (E(-1) / E(moment_norm(k)));
      if constexpr (!odd) add_multiple<row.value[0]>(out.rest, moment);
      unrolled<pairs>([&](auto p) ROW_INLINE { add_multiple<row.value[1 + 2 * p]>(out_half[p], moment); });
    }
  });
  return out;
}

/// The factors or rates of one fluid for every lane.
template <class V, class Real>
ROW_INLINE inline TrtFactors<V> in_lanes(const TrtFactors<Real>& k) {
  const auto all = broadcast<V>;
  return {all(k.keep_even), all(k.keep_odd), all(k.v_j), all(k.v_F), all(k.m_j), all(k.m_F)};
}

template <class V, class Real>
ROW_INLINE inline MrtRates<V> in_lanes(const MrtRates<Real>& s) {
  const auto all = broadcast<V>;
  return {all(s.e), all(s.eps), all(s.q), all(s.nu), all(s.pi), all(s.m)};
}

/// Those of the fluid that each lane is in.
template <class V, class Mask, class Real>
ROW_INLINE inline TrtFactors<V> in_lanes(const Mask& is_inside, const TrtFactors<Real>& in,
                                         const TrtFactors<Real>& out) {
  const auto one = [&](Real a, Real b) ROW_INLINE { return is_inside ? broadcast<V>(a) : broadcast<V>(b); };
  return {one(in.keep_even, out.keep_even),
          one(in.keep_odd, out.keep_odd),
          one(in.v_j, out.v_j),
          one(in.v_F, out.v_F),
          one(in.m_j, out.m_j),
          one(in.m_F, out.m_F)};
}

template <class V, class Mask, class Real>
ROW_INLINE inline MrtRates<V> in_lanes(const Mask& is_inside, const MrtRates<Real>& in, const MrtRates<Real>& out) {
  const auto one = [&](Real a, Real b) ROW_INLINE { return is_inside ? broadcast<V>(a) : broadcast<V>(b); };
  return {one(in.e, out.e),   one(in.eps, out.eps), one(in.q, out.q),
          one(in.nu, out.nu), one(in.pi, out.pi),   one(in.m, out.m)};
}

}  // namespace rouleau
