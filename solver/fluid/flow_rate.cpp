// SPDX-License-Identifier: BSD-3-Clause
// Order-free sums over the momentum of a block.
#include "fluid/flow_rate.hpp"

#include <bit>
#include <cmath>

#include "base/error.hpp"

namespace rouleau {

namespace {

/// Pointers to node x = 0 of a row of populations.
template <class Real>
std::array<const Real*, Q> row_of(const Fluid<Real>& fluid, int j, int k) {
  std::array<const Real*, Q> f;
  for (int q = 0; q < Q; ++q) f[q] = fluid.f.direction(q) + fluid.f.layout.index(0, j, k);
  return f;
}

/// sum_q c_q f_q of one node along one axis, in double: single populations are added without a further rounding error.
template <int axis, class Real>
ROW_INLINE inline double momentum(const std::array<const Real*, Q>& f, int x) {
  double sum = 0;
  unrolled<pairs>([&](auto p) ROW_INLINE {
    constexpr int c = c_q[1 + 2 * p][axis];
    if constexpr (c > 0) sum += double(f[1 + 2 * p][x]) - double(f[2 + 2 * p][x]);
    if constexpr (c < 0) sum += double(f[2 + 2 * p][x]) - double(f[1 + 2 * p][x]);
  });
  return sum;
}

template <class Real>
ROW_INLINE inline double density(const std::array<const Real*, Q>& f, int x) {
  double sum = 1;
  unrolled<Q>([&](auto q) ROW_INLINE { sum += double(f[q][x]); });
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

template <int axis, class Real>
RowMomentum row_momentum(const std::array<const Real*, Q>& f, int size) {
  std::int64_t sum = 0, out_of_range = 0;
  for (int x = 0; x < size; ++x) {
    const double v = momentum<axis>(f, x);
    sum += to_fixed_point(v);
    out_of_range += std::abs(v) < largest_momentum ? 0 : 1;  // counts NaN
  }
  return {sum, out_of_range};
}

/// For a row that has a bad node.
template <class Real>
[[noreturn]] void fail_at_first_bad(const Fluid<Real>& fluid, int j, int k) {
  const auto f = row_of(fluid, j, k);
  const auto is_good = [](double v) { return std::abs(v) < largest_momentum; };
  for (int x = 0;; ++x) {
    const double jx = momentum<0>(f, x), jy = momentum<1>(f, x), jz = momentum<2>(f, x);
    if (!is_good(jx) || !is_good(jy) || !is_good(jz))
      fail(Exit::physics,
           "the momentum of node ({}, {}, {}) is ({}, {}, {}); each component must be below {}. Try a smaller time "
           "step.",
           fluid.block.begin[0] + x, fluid.block.begin[1] + j, fluid.block.begin[2] + k, jx, jy, jz, largest_momentum);
  }
}

struct NodeSpeed {
  double rho, square;
};

template <class Real>
ROW_INLINE inline NodeSpeed node_speed(const std::array<const Real*, Q>& f, int x) {
  const double jx = momentum<0>(f, x), jy = momentum<1>(f, x), jz = momentum<2>(f, x), rho = density(f, x);
  return {rho, (jx * jx + jy * jy + jz * jz) / (rho * rho)};
}

/// False for NaN.
ROW_INLINE inline bool is_sound(const NodeSpeed& node, double limit_squared) {
  return (node.square <= limit_squared) & (node.rho > 0) & (node.rho < 2);
}

}  // namespace

template <class Real>
std::array<std::int64_t, 3> momentum_fixed_point(const Fluid<Real>& fluid) {
  const Int3& size = fluid.block.size;
  std::array<std::int64_t, 3> total{};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const auto f = row_of(fluid, j, k);
      const std::array<RowMomentum, 3> row{row_momentum<0>(f, size[0]), row_momentum<1>(f, size[0]),
                                           row_momentum<2>(f, size[0])};
      for (int a = 0; a < 3; ++a) {
        if (row[a].out_of_range != 0) fail_at_first_bad(fluid, j, k);
        total[a] += row[a].sum;
      }
    }
  return total;
}

template <class Real>
SpeedCheck check_speed(const Fluid<Real>& fluid, double limit) {
  const Int3& size = fluid.block.size;
  const double limit_squared = limit * limit;
  double largest = 0;
  SpeedCheck check;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const auto f = row_of(fluid, j, k);
      std::int64_t bad = 0;
      for (int x = 0; x < size[0]; ++x) {
        const NodeSpeed node = node_speed(f, x);
        const bool good = is_sound(node, limit_squared);
        bad += good ? 0 : 1;
        largest = good && node.square > largest ? node.square : largest;
      }
      for (int x = 0; bad != 0 && !check.first_bad && x < size[0]; ++x)
        if (!is_sound(node_speed(f, x), limit_squared))
          check.first_bad = {fluid.block.begin[0] + x, fluid.block.begin[1] + j, fluid.block.begin[2] + k};
    }
  check.max_speed = std::sqrt(largest);
  return check;
}

template std::array<std::int64_t, 3> momentum_fixed_point(const Fluid<float>&);
template std::array<std::int64_t, 3> momentum_fixed_point(const Fluid<double>&);
template SpeedCheck check_speed(const Fluid<float>&, double);
template SpeedCheck check_speed(const Fluid<double>&, double);

}  // namespace rouleau
