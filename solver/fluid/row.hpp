// SPDX-License-Identifier: BSD-3-Clause
// The row loop of the fluid: a view of one row of nodes, and the step of its nodes in the variant that the row needs.
#pragma once

#include "fluid/relax.hpp"

namespace rouleau {

/// Pointers to node x = 0 of a row in everything its step reads and writes.
template <class Real>
struct Row {
  int size = 0;
  std::array<const Real*, Q> from{};  ///< f_q of the node that direction q streams here from
  std::array<Real*, Q> to{};          ///< f_q after this step
  std::array<const Real*, 3> g{};     ///< membrane force
  std::array<Real*, 3> u{};           ///< velocity
  const Real* inside = nullptr;       ///< 1 inside a cell, 0 outside
  Real3<Real> body_force{};
};

/// What is known of a whole row, so that the loop over it has no branches.
struct RowKind {
  bool has_force, wants_velocity, has_inside;
};

template <class Real>
ROW_INLINE inline Halves<Real> pull(const Row<Real>& row, int x) {
  Halves<Real> f;
  f.rest = row.from[0][x];
  unrolled<pairs>([&](auto p) ROW_INLINE {
    const Real plus = row.from[1 + 2 * p][x], minus = row.from[2 + 2 * p][x];
    f.even[p] = Real(0.5) * (plus + minus);
    f.odd[p] = Real(0.5) * (plus - minus);
  });
  return f;
}

template <class Real>
ROW_INLINE inline void push(const Row<Real>& row, int x, const Halves<Real>& f) {
  row.to[0][x] = f.rest;
  unrolled<pairs>([&](auto p) ROW_INLINE {
    row.to[1 + 2 * p][x] = f.even[p] + f.odd[p];
    row.to[2 + 2 * p][x] = f.even[p] - f.odd[p];
  });
}

template <bool has_force, class Real>
ROW_INLINE inline Real3<Real> force_at(const Row<Real>& row, int x) {
  const Real3<Real>& G = row.body_force;
  if constexpr (has_force) return {G[0] + row.g[0][x], G[1] + row.g[1][x], G[2] + row.g[2][x]};
  return {G[0], G[1], G[2]};
}

template <class Real>
ROW_INLINE inline Real select(bool is_inside, Real inside, Real outside) {
  return is_inside ? inside : outside;
}

template <class Real>
ROW_INLINE inline TrtRates<Real> select(bool is_inside, const TrtRates<Real>& in, const TrtRates<Real>& out) {
  return {select(is_inside, in.even, out.even), select(is_inside, in.odd, out.odd)};
}

template <class Real>
ROW_INLINE inline MrtRates<Real> select(bool is_inside, const MrtRates<Real>& in, const MrtRates<Real>& out) {
  return {select(is_inside, in.e, out.e),   select(is_inside, in.eps, out.eps), select(is_inside, in.q, out.q),
          select(is_inside, in.nu, out.nu), select(is_inside, in.pi, out.pi),   select(is_inside, in.m, out.m)};
}

template <RowKind kind, class Real, class Rates>
ROW_INLINE inline void step_node(const Row<Real>& row, const TwoFluids<Rates>& rates, int x) {
  const Halves<Real> f = pull(row, x);
  const Moments<Real> m = moments(f, force_at<kind.has_force>(row, x));
  if constexpr (kind.wants_velocity) unrolled<3>([&](auto a) ROW_INLINE { row.u[a][x] = m.u[a]; });
  if constexpr (kind.has_inside)
    push(row, x, collide(f, m, select(row.inside[x] != Real(0), rates.inside, rates.outside)));
  else
    push(row, x, collide(f, m, rates.outside));
}

/// The body of the loop is one call: variables of the loop itself would be made arrays over its lanes by `omp simd`,
/// which stops vectorisation; those of an inlined function become registers first.
template <RowKind kind, class Real, class Rates>
void step_row_as(const Row<Real>& row, const TwoFluids<Rates>& rates) {
  ROW_LOOP
  for (int x = 0; x < row.size; ++x) step_node<kind>(row, rates, x);
}

/// Streams and collides the nodes of one row, in one of eight loops.
template <class Real, class Rates>
void step_row(const Row<Real>& row, const RowKind& kind, const TwoFluids<Rates>& rates) {
  const int variant = 4 * kind.has_force + 2 * kind.wants_velocity + kind.has_inside;
  unrolled<8>([&](auto v) {
    if (variant == v) step_row_as<RowKind{(v & 4) != 0, (v & 2) != 0, (v & 1) != 0}>(row, rates);
  });
}

}  // namespace rouleau
