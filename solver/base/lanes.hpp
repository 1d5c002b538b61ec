// SPDX-License-Identifier: BSD-3-Clause
// The nodes of a stencil that stand beside each other in memory, as one vector register.
#pragma once

#include <cstring>
#include <utility>

namespace rouleau {

/// Values of `width` nodes of a row: the compiler's own vector type, with its operators + and *. Of three nodes the
/// fourth lane is 0, and not written back.
template <class Real, int width>
struct LanesOf {
  typedef Real type __attribute__((vector_size(sizeof(Real) * (width == 3 ? 4 : width))));  // NOLINT: no `using` form
};
template <class Real, int width>
using Lanes = typename LanesOf<Real, width>::type;

/// from[0], ..., from[width - 1] as Real: from memory, or from lanes of another type. Written out element by element,
/// which the compiler turns into one load or conversion; its __builtin_convertvector takes a detour (g++ 12).
template <class Real, int width, class From>
Lanes<Real, width> load_lanes(const From& from) {
  return [&]<int... a>(std::integer_sequence<int, a...>) { return Lanes<Real, width>{static_cast<Real>(from[a])...}; }
  (std::make_integer_sequence<int, width>{});
}

template <int width, class Real>
void store_lanes(const Lanes<Real, width>& values, Real* to) {
  std::memcpy(to, &values, width * sizeof(Real));
}

}  // namespace rouleau
