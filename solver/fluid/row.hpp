// SPDX-License-Identifier: BSD-3-Clause
// The row loop of the fluid: a view of one row of nodes, and the step of its nodes in the variant that the row needs.
#pragma once

#include "fluid/relax.hpp"

namespace rouleau {

/// Pointers to node x = 0 of a row in everything its step reads and writes. Whole packs are read: behind the last node
/// there must be memory, whose values do not matter.
template <class Real>
struct Row {
  std::array<Real*, Q> f{};  ///< f_q: where direction q streams here from, one node further along x; then f_q here
  std::array<const Real*, 3> g{};  ///< membrane force
  std::array<Real*, 3> u{};        ///< velocity
  const Real* inside = nullptr;    ///< 1 inside a cell, 0 outside
  Real3<Real> body_force{};
};

/// What is known of a part of a row, so that the loop over it has no branches: whether membranes touch it (there is
/// force, and the velocity is wanted) and whether it has nodes inside cells.
struct RowKind {
  bool has_membrane, has_inside;
};

/// The directions with c_x = +1, and with c_x = -1.
inline constexpr std::array<int, 5> eastward = directions_out(0, 1), westward = directions_out(0, 0);

/// The packs of the eastward directions to the west of the one in work: they are read before a step overwrites them. Of
/// each only the last lane counts.
template <class Real>
using WestPacks = std::array<Pack<Real>, 5>;

template <class Real>
ROW_INLINE inline Pulled<Pack<Real>> pull(const Row<Real>& row, int x, WestPacks<Real>& west) {
  std::array<Pack<Real>, Q> f;
  unrolled<Q>([&](auto q) ROW_INLINE { f[q] = load(row.f[q] + x - (c_q[q][0] < 0 ? c_q[q][0] : 0)); });
  unrolled<5>([&](auto e) ROW_INLINE {
    const Pack<Real> here = f[eastward[e]];
    f[eastward[e]] = shifted_east(west[e], here);
    west[e] = here;
  });
  Pulled<Pack<Real>> pulled;
  pulled.rest = f[0];
  unrolled<pairs>([&](auto p) ROW_INLINE {
    pulled.sum[p] = f[1 + 2 * p] + f[2 + 2 * p];
    pulled.difference[p] = f[1 + 2 * p] - f[2 + 2 * p];
  });
  return pulled;
}

/// How a pack of results is stored: as a whole, or its first nodes at the end of a row that is no multiple of a pack.
struct WholePack {
  template <class Real>
  ROW_INLINE void operator()(Real* to, const Pack<Real>& pack) const {
    store(to, pack);
  }
};
struct FirstNodes {
  int count;
  template <class Real>
  ROW_INLINE void operator()(Real* to, const Pack<Real>& pack) const {
    store_first(to, pack, count);
  }
};

template <class Real, class Store>
ROW_INLINE inline void push(const Row<Real>& row, int x, const Halves<Pack<Real>>& f, const Store& store_pack) {
  store_pack(row.f[0] + x, f.rest);
  unrolled<pairs>([&](auto p) ROW_INLINE {
    store_pack.template operator()<Real>(row.f[1 + 2 * p] + x, f.even[p] + f.odd[p]);
    store_pack.template operator()<Real>(row.f[2 + 2 * p] + x, f.even[p] - f.odd[p]);
  });
}

template <bool has_membrane, class Real>
ROW_INLINE inline Real3<Pack<Real>> force_at(const Row<Real>& row, int x) {
  Real3<Pack<Real>> F;
  unrolled<3>([&](auto a) ROW_INLINE {
    F[a] = broadcast<Pack<Real>>(row.body_force[a]);
    if constexpr (has_membrane) F[a] += load(row.g[a] + x);
  });
  return F;
}

template <RowKind kind, class Real, class Rates, class Store>
ROW_INLINE inline void step_pack(const Row<Real>& row, const TwoFluids<Rates>& rates, int x, WestPacks<Real>& west,
                                 const Store& store_pack) {
  using V = Pack<Real>;
  const Pulled<V> f = pull(row, x, west);
  const Moments<V> m = moments(f, force_at<kind.has_membrane>(row, x));
  if constexpr (kind.has_membrane)
    unrolled<3>([&](auto a) ROW_INLINE { store_pack.template operator()<Real>(row.u[a] + x, m.u[a]); });
  if constexpr (kind.has_inside)
    push(row, x, collide(f, m, in_lanes<V>(load(row.inside + x) != V{}, rates.inside, rates.outside)), store_pack);
  else
    push(row, x, collide(f, m, in_lanes<V>(rates.outside)), store_pack);
}

template <RowKind kind, class Real, class Rates>
void step_row_as(const Row<Real>& row, Run run, const TwoFluids<Rates>& rates, WestPacks<Real>& west) {
  WestPacks<Real> west_here = west;
  int x = run.begin;
  for (; x + lanes<Real> <= run.end; x += lanes<Real>) step_pack<kind>(row, rates, x, west_here, WholePack{});
  if (x < run.end) step_pack<kind>(row, rates, x, west_here, FirstNodes{run.end - x});
  west = west_here;
}

/// Streams and collides a run of a row, in one of four loops. A run begins on a pack, and ends on one unless it is the
/// last of its row. `west` goes on from run to run.
template <class Real, class Rates>
void step_row(const Row<Real>& row, Run run, const RowKind& kind, const TwoFluids<Rates>& rates,
              WestPacks<Real>& west) {
  const int variant = 2 * kind.has_membrane + kind.has_inside;
  unrolled<4>([&](auto v) {
    if (variant == v) step_row_as<RowKind{(v & 2) != 0, (v & 1) != 0}>(row, run, rates, west);
  });
}

}  // namespace rouleau
