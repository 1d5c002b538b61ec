// SPDX-License-Identifier: BSD-3-Clause
// Storage for structures of arrays: vectors that start on a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace rouleau {

inline constexpr std::size_t cache_line = 64;

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}  // NOLINT: the standard's rebind needs it implicit
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{cache_line})); }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{cache_line}); }
  bool operator==(const AlignedAllocator&) const { return true; }
};

template <class T>
using Array = std::vector<T, AlignedAllocator<T>>;

/// Three arrays, one a component: a vector a vertex.
struct VectorArray {
  Array<double> x, y, z;

  VectorArray() = default;
  explicit VectorArray(std::size_t n) : x(n), y(n), z(n) {}
  [[nodiscard]] std::size_t size() const { return x.size(); }
  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
};

}  // namespace rouleau
