// SPDX-License-Identifier: BSD-3-Clause
// Order-free sums over the momentum of a block.
#include "fluid/flow_rate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "fluid/equilibrium.hpp"

namespace rouleau {

namespace {

/// Pointers to node x = 0 of a row of populations.
template <class Real>
using PopulationRow = std::array<const Real*, Q>;

template <class Real>
PopulationRow<Real> row_of(const Fluid<Real>& fluid, int j, int k) {
  PopulationRow<Real> f;
  for (int q = 0; q < Q; ++q) f[q] = fluid.f.rows(q)(j, k);
  return f;
}

/// sum_q c_q f_q of one node along one axis, in its own precision.
template <int axis, class Real>
ROW_INLINE inline Real momentum(const PopulationRow<Real>& f, int x) {
  Real sum = 0;
  unrolled<pairs>([&](auto p) ROW_INLINE {
    constexpr int c = c_q[1 + 2 * p][axis];
    if constexpr (c > 0) sum += f[1 + 2 * p][x] - f[2 + 2 * p][x];
    if constexpr (c < 0) sum += f[2 + 2 * p][x] - f[1 + 2 * p][x];
  });
  return sum;
}

/// Nearest integer to v 2^36, ties to even, for |v| < 2^15: adding 1.5 2^52 leaves the integer in the low bits of the
/// sum. Written so that it vectorises on every machine, which a conversion to 64-bit integers does not.
ROW_INLINE inline std::int64_t to_fixed_point(double v) {
  constexpr double shift = 0x1.8p52;
  return std::bit_cast<std::int64_t>(v * momentum_scale + shift) - std::bit_cast<std::int64_t>(shift);
}

struct RowMomentum {
  std::int64_t sum = 0;
  std::int64_t out_of_range = 0;  ///< nodes
};

/// In chunks: g++ vectorises the sums of one loop and the conversion of the next at their own widths.
template <int axis, class Real>
RowMomentum row_momentum(const PopulationRow<Real>& f, int size) {
  constexpr int chunk = 64;
  std::array<Real, chunk> j;
  RowMomentum row;
  for (int begin = 0; begin < size; begin += chunk) {
    const int count = std::min(chunk, size - begin);
    ROW_LOOP
    for (int i = 0; i < count; ++i) j[static_cast<std::size_t>(i)] = momentum<axis>(f, begin + i);
    for (int i = 0; i < count; ++i) {
      const double v = j[static_cast<std::size_t>(i)];
      row.sum += to_fixed_point(v);
      row.out_of_range += std::abs(v) < largest_momentum ? 0 : 1;  // counts NaN
    }
  }
  return row;
}

/// For a row that has a bad node.
template <int axis, class Real>
[[noreturn]] void fail_at_first_bad(const Fluid<Real>& fluid, int j, int k) {
  const PopulationRow<Real> f = row_of(fluid, j, k);
  for (int x = 0;; ++x) {
    const double v = momentum<axis>(f, x);
    if (!(std::abs(v) < largest_momentum))
      fail(Exit::physics,
           "the momentum of node ({}, {}, {}) along {} is {}; it must be below {}. Try a smaller time step.",
           fluid.block.begin[0] + x, fluid.block.begin[1] + j, fluid.block.begin[2] + k, "xyz"[axis], v,
           largest_momentum);
  }
}

template <int axis, class Real>
std::int64_t momentum_along(const Fluid<Real>& fluid) {
  const Int3& size = fluid.block.size;
  std::int64_t total = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const RowMomentum row = row_momentum<axis>(row_of(fluid, j, k), size[0]);
      if (row.out_of_range != 0) fail_at_first_bad<axis>(fluid, j, k);
      total += row.sum;
    }
  return total;
}

template <class T>
struct NodeSpeed {
  T rho_1, square;
};

template <class T, class Real>
ROW_INLINE inline NodeSpeed<T> node_speed(const PopulationRow<Real>& f, int x) {
  const auto value = [&](int q) ROW_INLINE {
    T v;
    std::memcpy(&v, f[static_cast<std::size_t>(q)] + x, sizeof v);
    return v;
  };
  Pulled<T> here;
  here.rest = value(0);
  unrolled<pairs>([&](auto p) ROW_INLINE {
    here.sum[p] = value(1 + 2 * p) + value(2 + 2 * p);
    here.difference[p] = value(1 + 2 * p) - value(2 + 2 * p);
  });
  const Moments<T> m = moments(here, Real3<T>{});
  return {m.rho_1, dot(m.u, m.u)};
}

/// False for NaN.
template <class T>
ROW_INLINE inline auto is_sound(const NodeSpeed<T>& node, Element<T> limit_squared) {
  return (node.square <= limit_squared) & (node.rho_1 > Element<T>(-1)) & (node.rho_1 < Element<T>(1));
}

/// Of the nodes from x on that fit whole packs: raises `largest` to their largest square that is sound, returns whether
/// all are.
template <class Real>
bool check_packs(const PopulationRow<Real>& f, int size, Real limit_squared, Pack<Real>& largest) {
  auto all_sound = Pack<Real>{} == Pack<Real>{};
  for (int x = 0; x + lanes<Real> <= size; x += lanes<Real>) {
    const auto node = node_speed<Pack<Real>>(f, x);
    const auto sound = is_sound(node, limit_squared);
    all_sound &= sound;
    largest = (sound & (node.square > largest)) ? node.square : largest;
  }
  bool all = true;
  for (int lane = 0; lane < lanes<Real>; ++lane) all &= all_sound[lane] != 0;
  return all;
}

}  // namespace

template <class Real>
std::int64_t momentum_fixed_point(const Fluid<Real>& fluid, int axis) {
  if (axis == 0) return momentum_along<0>(fluid);
  return axis == 1 ? momentum_along<1>(fluid) : momentum_along<2>(fluid);
}

template <class Real>
SpeedCheck check_speed(const Fluid<Real>& fluid, double limit) {
  const Int3& size = fluid.block.size;
  const auto limit_squared = static_cast<Real>(limit * limit);
  Pack<Real> largest_in_lanes{};
  Real largest = 0;
  SpeedCheck check;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const PopulationRow<Real> f = row_of(fluid, j, k);
      const bool packs_are_sound = check_packs(f, size[0], limit_squared, largest_in_lanes);
      // One by one: the nodes behind the last whole pack, or all of a row with a bad one.
      for (int x = packs_are_sound ? size[0] / lanes<Real> * lanes<Real> : 0; x < size[0]; ++x) {
        const auto node = node_speed<Real>(f, x);
        if (is_sound(node, limit_squared))
          largest = std::max(largest, node.square);
        else if (!check.first_bad) {
          check.first_bad = {fluid.block.begin[0] + x, fluid.block.begin[1] + j, fluid.block.begin[2] + k};
          check.bad_speed = std::sqrt(static_cast<double>(node.square));
          check.bad_rho = 1 + static_cast<double>(node.rho_1);
        }
      }
    }
  for (int lane = 0; lane < lanes<Real>; ++lane) largest = std::max<Real>(largest, largest_in_lanes[lane]);
  check.max_speed = std::sqrt(static_cast<double>(largest));
  return check;
}

template std::int64_t momentum_fixed_point(const Fluid<float>&, int);
template std::int64_t momentum_fixed_point(const Fluid<double>&, int);
template SpeedCheck check_speed(const Fluid<float>&, double);
template SpeedCheck check_speed(const Fluid<double>&, double);

}  // namespace rouleau
