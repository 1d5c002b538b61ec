// SPDX-License-Identifier: BSD-3-Clause
// How fast one core steps the fluid, beside a scaled copy of the same arrays: the best of several rounds.
//   fluid_speed [size_x size_y size_z]
#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <vector>

#include "support/one_block.hpp"

namespace rouleau {
namespace {

template <class Work>
double best_seconds(Work work) {
  constexpr int rounds = 12, repeats = 10;
  double best = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (int n = 0; n < repeats; ++n) work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    best = std::min(best, seconds.count() / repeats);
  }
  return best;
}

/// What memory allows: reads one copy of the populations and writes the other, with one product a value.
template <class Real>
double copy_seconds(Fluid<Real>& fluid) {
  return best_seconds([&] {
    const Real* from = fluid.f.data.data();
    Real* to = fluid.f_next.data.data();
    const auto n = static_cast<std::ptrdiff_t>(fluid.f.data.size());
    ROW_LOOP
    for (std::ptrdiff_t i = 0; i < n; ++i) to[i] = Real(1.0000001) * from[i];
    asm volatile("" ::"r"(to) : "memory");
  });
}

/// `is_busy`: every row has membrane force, cells and readers of its velocity; otherwise none has.
template <class Real>
void measure(const char* name, const Int3& size, const Collision& collision, bool is_busy) {
  testing::OneBlock<Real> block({size, {true, false, false}}, collision);
  block.body_force = Vec3(1e-6, 0, 0);
  if (is_busy)
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j) block.inside(size[0] / 2, j, k) = 1;
  const std::vector<std::uint8_t> none(static_cast<std::size_t>(size[1] * size[2]), 0);
  const RowMasks masks = is_busy ? RowMasks{} : RowMasks{none, none};
  const double step = best_seconds([&] { block.step(masks); }), copy = copy_seconds(block.fluid);
  const double mega_nodes = static_cast<double>(block.fluid.lattice.nodes()) / 1e6;
  fmt::print("{} {} {:<13} {:7.1f} million node updates a second, {:4.0f} % of a scaled copy\n", name,
             sizeof(Real) == 4 ? "single" : "double", is_busy ? "with cells" : "without cells", mega_nodes / step,
             100 * copy / step);
}

void measure_all(const Int3& size) {
  const Collision trt = testing::two_trt(1.0 / 6, 5.0 / 6);
  const Collision mrt = TwoFluids<MrtRates<>>{mrt_rates(1.0 / 6, 1, 1), mrt_rates(5.0 / 6, 1, 1)};
  for (const bool is_busy : {false, true}) {
    measure<float>("TRT", size, trt, is_busy);
    measure<double>("TRT", size, trt, is_busy);
    measure<float>("MRT", size, mrt, is_busy);
    measure<double>("MRT", size, mrt, is_busy);
  }
}

}  // namespace
}  // namespace rouleau

int main(int argc, char** argv) {
  rouleau::Int3 size{128, 36, 30};
  for (int a = 0; a < 3 && argc == 4; ++a) size[a] = std::atoi(argv[a + 1]);
  rouleau::measure_all(size);
}
