// SPDX-License-Identifier: BSD-3-Clause
// Discrete delta functions: how a vertex between nodes shares its force, and hears its velocity, along one axis.
//
// Each kernel gives, for a vertex at X, the first node of its stencil and the weights phi(X - node) of `width` nodes in
// a row. The weight of a node of the lattice is the product over the three axes. All kernels have sum 1 and first
// moment 0 for every X; what each has beyond that stands at the kernel.
//
// [Roma1999]   Roma, Peskin, Berger, J Comput Phys 153 (1999) 509
// [Peskin2002] Peskin, Acta Numerica 11 (2002) 479
#pragma once

#include <array>
#include <cmath>
#include <string_view>

namespace rouleau {

/// Trilinear, 8 nodes: the sharpest. The kernel of ESPResSo's tracers, and so most likely of the paper.
struct TwoPoint {
  static constexpr int width = 2;
  static double first_node(double X) { return std::floor(X); }
  /// Weights for a vertex at distance `s` (in [0, 1]) from the first node.
  static std::array<double, 2> weights(double s) { return {1.0 - s, s}; }
};

/// [Roma1999], 27 nodes: the sum of squares is 1/2 for every X.
struct ThreePoint {
  static constexpr int width = 3;
  static double first_node(double X) { return std::floor(X + 0.5) - 1.0; }
  /// Weights for a vertex at distance `s` (in [1/2, 3/2]) from the first node.
  static std::array<double, 3> weights(double s) {
    const double f = s - 1.0;
    const double root = std::sqrt(1.0 - 3.0 * f * f);
    return {(2.0 - 3.0 * f - root) / 6.0, (1.0 + root) / 3.0, (2.0 + 3.0 * f - root) / 6.0};
  }
};

/// [Peskin2002] section 6, 64 nodes: even and odd nodes hold 1/2 each and the sum of squares is 3/8 for every X.
struct FourPoint {
  static constexpr int width = 4;
  static double first_node(double X) { return std::floor(X) - 1.0; }
  /// Weights for a vertex at distance `s` (in [1, 2]) from the first node.
  static std::array<double, 4> weights(double s) {
    const double f = s - 1.0;
    const double root = std::sqrt(1.0 + 4.0 * f * (1.0 - f));
    return {(3.0 - 2.0 * f - root) / 8.0, (3.0 - 2.0 * f + root) / 8.0, (1.0 + 2.0 * f + root) / 8.0,
            (1.0 + 2.0 * f - root) / 8.0};
  }
};

enum class Kernel { two_point, three_point, four_point };

/// Calls `work` with the kernel's law, so that the choice is made once, outside the loop.
template <class Work>
decltype(auto) with_kernel(Kernel kernel, Work&& work) {
  switch (kernel) {
    case Kernel::two_point:
      return work(TwoPoint{});
    case Kernel::three_point:
      return work(ThreePoint{});
    case Kernel::four_point:
      break;
  }
  return work(FourPoint{});
}

inline int kernel_width(Kernel kernel) {
  return with_kernel(kernel, [](auto phi) { return decltype(phi)::width; });
}

inline std::string_view kernel_name(Kernel kernel) {
  constexpr std::array<std::string_view, 3> names{"2-point", "3-point", "4-point"};
  return names[static_cast<std::size_t>(kernel)];
}

}  // namespace rouleau
