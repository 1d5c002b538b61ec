// SPDX-License-Identifier: BSD-3-Clause
// How a loop over a row of nodes is asked to vectorise, and how a loop over lattice directions is unrolled.
#pragma once

#include <type_traits>
#include <utility>

/// Before a `for` over the nodes of a row: its iterations are independent, vectorise it. Needs -fopenmp-simd (no OpenMP
/// runtime). The bits of a node do not depend on its place in a vector, since contraction is off and all operations are
/// IEEE.
#define ROW_LOOP _Pragma("omp simd")

/// On a function or lambda that must vanish into the row loop that calls it: a call left over would stop vectorisation.
/// Without optimisation there is no vectorisation to save, and forced inlining would only make a huge debug build.
#ifdef __OPTIMIZE__
#define ROW_INLINE __attribute__((always_inline))
#else
#define ROW_INLINE
#endif

namespace rouleau {

/// Calls body(0), ..., body(N - 1) with compile-time indices (`std::integral_constant`), in this order and without a
/// loop, so that table entries such as c_q fold into the code. Mark the body ROW_INLINE.
template <int N, class Body>
ROW_INLINE inline constexpr void unrolled(Body&& body) {
  [&]<int... i>(std::integer_sequence<int, i...>) ROW_INLINE { (body(std::integral_constant<int, i>{}), ...); }
  (std::make_integer_sequence<int, N>{});
}

}  // namespace rouleau
