// SPDX-License-Identifier: BSD-3-Clause
#include "crash/damage/figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rouleau::testing {

namespace {

class Printer : public ::testing::Environment {
 public:
  void TearDown() override {
    const Figures& all = figures();
    std::printf("{\"damage_positions\": %ld, \"undetected\": %ld, \"wrong_resumes\": %ld}\n", all.damage_positions,
                all.undetected, all.wrong_resumes);
  }
};

[[maybe_unused]] const auto* const printer = ::testing::AddGlobalTestEnvironment(new Printer);

}  // namespace

Figures& figures() {
  static Figures all;
  return all;
}

std::size_t spread(int i, std::size_t size) {
  double whole = 0;
  return std::min(
      size - 1, static_cast<std::size_t>(std::modf(0.5 + i * 0.6180339887498949, &whole) * static_cast<double>(size)));
}

std::string damaged(const std::string& sound, std::size_t place, int i) {
  std::string bytes = sound;
  if (i % 5 == 3) {
    bytes.resize(place);
    return bytes;
  }
  if (i % 5 == 4) {
    constexpr std::size_t page = 4096;
    const std::size_t begin = place / page * page, length = std::min(page, bytes.size() - begin);
    bytes.replace(begin, length, length, '\0');
    if (bytes != sound) return bytes;
  }
  bytes[place] = static_cast<char>(bytes[place] ^ (1U << static_cast<unsigned>(i) % 8U));
  return bytes;
}

}  // namespace rouleau::testing
