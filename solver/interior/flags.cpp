// SPDX-License-Identifier: BSD-3-Clause
#include "interior/flags.hpp"

#include <algorithm>

namespace rouleau {

std::int64_t count_inside(const Flags& flags) {
  const Int3& size = flags.layout.size;
  std::int64_t inside = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const std::uint8_t* const row = &flags(0, j, k);
      inside += std::count(row, row + size[0], std::uint8_t{1});
    }
  return inside;
}

void clear_owned(Flags& flags) {
  const Int3& size = flags.layout.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) std::fill_n(&flags(0, j, k), size[0], std::uint8_t{0});
}

}  // namespace rouleau
