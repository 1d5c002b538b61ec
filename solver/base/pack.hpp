// SPDX-License-Identifier: BSD-3-Clause
// Packs: as many numbers as one vector register of the target holds, worked on together.
//
// Built on the compiler's vector types: + - * / and comparisons act lane by lane, a single number is broadcast. Used
// where a loop must be vectorised whatever the compiler thinks of it; its lanes round like the plain operations.
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__AVX512F__) || defined(__FMA__)
#include <immintrin.h>
#endif

#include "base/simd.hpp"

namespace rouleau {

#if defined(__AVX512F__)
inline constexpr int pack_bytes = 64;
#elif defined(__AVX__)
inline constexpr int pack_bytes = 32;
#else
inline constexpr int pack_bytes = 16;
#endif

template <class Real>
struct PackOf {
  using type __attribute__((vector_size(pack_bytes))) = Real;
};
template <class Real>
using Pack = typename PackOf<Real>::type;

/// Numbers in a pack.
template <class Real>
inline constexpr int lanes = pack_bytes / static_cast<int>(sizeof(Real));

/// The number type of a pack, or of a plain number.
template <class T>
struct ElementOf {
  using type = std::remove_cvref_t<decltype(std::declval<T>()[0])>;
};
template <>
struct ElementOf<float> {
  using type = float;
};
template <>
struct ElementOf<double> {
  using type = double;
};
template <class T>
using Element = typename ElementOf<T>::type;

/// `value` in every lane.
template <class T>
ROW_INLINE inline T broadcast(Element<T> value) {
  return value - T{};
}

template <class Real>
ROW_INLINE inline Pack<Real> load(const Real* from) {
  Pack<Real> pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}

template <class Real>
ROW_INLINE inline void store(Real* to, const Pack<Real>& pack) {
  std::memcpy(to, &pack, sizeof pack);
}

/// The first `count` lanes, 0 < count < lanes.
template <class Real>
ROW_INLINE inline void store_first(Real* to, const Pack<Real>& pack, int count) {
#if defined(__AVX512F__)
  if constexpr (std::is_same_v<Real, float>)
    _mm512_mask_storeu_ps(to, static_cast<__mmask16>((1U << count) - 1), pack);
  else
    _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1), pack);
#else
  std::memcpy(to, &pack, static_cast<std::size_t>(count) * sizeof(Real));
#endif
}

/// a b + c, rounded once, of plain numbers or packs.
template <class T>
ROW_INLINE inline T fused(const T& a, const T& b, const T& c) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::fma(a, b, c);
  } else {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<Element<T>, float>)
      return _mm512_fmadd_ps(a, b, c);
    else
      return _mm512_fmadd_pd(a, b, c);
#elif defined(__FMA__)
    if constexpr (std::is_same_v<Element<T>, float>)
      return _mm256_fmadd_ps(a, b, c);
    else
      return _mm256_fmadd_pd(a, b, c);
#else
    T sum;
    for (int lane = 0; lane < lanes<Element<T>>; ++lane) sum[lane] = std::fma(a[lane], b[lane], c[lane]);
    return sum;
#endif
  }
}

/// The same with a plain factor.
template <class T>
ROW_INLINE inline T fused(Element<T> a, const T& b, const T& c) requires(!std::is_floating_point_v<T>) {
  return fused(broadcast<T>(a), b, c);
}

/// The last lane of `before`, then all but the last of `pack`: a row of packs seen one node further west.
template <class V>
ROW_INLINE inline V shifted_east(const V& before, const V& pack) {
  constexpr int n = lanes<Element<V>>;
  return [&]<int... i>(std::integer_sequence<int, i...>) ROW_INLINE {
    return __builtin_shufflevector(before, pack, (i + n - 1)...);
  }
  (std::make_integer_sequence<int, n>{});
}

}  // namespace rouleau
