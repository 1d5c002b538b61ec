// SPDX-License-Identifier: BSD-3-Clause
// Storage for structures of arrays: vectors that start on a cache line.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace rouleau {

inline constexpr std::size_t cache_line = 64;

/// Large arrays start on a huge page and ask the system for such pages: a step walks so many of them side by side that
/// small pages overflow the table of translations (a third of the fluid's speed).
inline constexpr std::size_t huge_page = std::size_t{1} << 21;

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}  // NOLINT: the standard's rebind needs it implicit
  T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    void* const begin = ::operator new(bytes, alignment(bytes));
#ifdef MADV_HUGEPAGE
    if (bytes >= huge_page) (void)::madvise(begin, bytes, MADV_HUGEPAGE);  // without them all works, only slower
#endif
    return static_cast<T*>(begin);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n * sizeof(T))); }
  bool operator==(const AlignedAllocator&) const { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= huge_page ? huge_page : cache_line};
  }
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
