// SPDX-License-Identifier: BSD-3-Clause
// Replaces operator new of a test program by one that counts: include it in one source file of the program only.
#pragma once

#include <cstdlib>
#include <new>

namespace rouleau::testing {

inline long allocations = 0;

inline void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}

}  // namespace rouleau::testing

// Not inlined: g++ would see malloc() at one end and delete at the other, and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  return rouleau::testing::counted(bytes, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return rouleau::testing::counted(bytes, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
