// SPDX-License-Identifier: BSD-3-Clause
// A sum whose order of additions is fixed: eight partial sums, whatever the width of the machine's registers.
#pragma once

#include <cstddef>

namespace rouleau {

/// Sum of `term(i)` for i in [begin, end): term i goes to partial sum (i - begin) % 8, and the eight are added
/// pairwise. `term` is called once an index; it may store side results at that index.
template <class Term>
double ordered_sum(std::ptrdiff_t begin, std::ptrdiff_t end, Term&& term) {
  constexpr int lanes = 8;
  double part[lanes] = {};
  std::ptrdiff_t i = begin;
  for (; i + lanes <= end; i += lanes) {
#pragma omp simd
    for (int l = 0; l < lanes; ++l) part[l] += term(i + l);
  }
  for (int l = 0; i + l < end; ++l) part[l] += term(i + l);
  return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

}  // namespace rouleau
