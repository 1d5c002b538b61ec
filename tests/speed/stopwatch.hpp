// SPDX-License-Identifier: BSD-3-Clause
// Wall-clock time of a piece of work.
#pragma once

#include <chrono>

namespace rouleau::speed {

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Mean time of a call, over calls that fill `enough_s`. The first call brings the data into the caches again, which
/// other cases have filled since; it counts only if it is long by itself.
template <class Work>
double seconds_per_call(double enough_s, const Work& work) {
  const double first = seconds_of(work);
  if (first >= enough_s) return first;
  double spent = 0;
  int calls = 0;
  for (; spent < enough_s; ++calls) spent += seconds_of(work);
  return spent / calls;
}

}  // namespace rouleau::speed
