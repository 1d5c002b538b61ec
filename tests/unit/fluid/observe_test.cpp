// SPDX-License-Identifier: BSD-3-Clause
// What is read off the state between two steps is what the next step computes.
#include "fluid/observe.hpp"

#include <gtest/gtest.h>

#include "fluid/initial.hpp"
#include "fluid/walls.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

using testing::OneBlock;
using testing::swirl;

/// A flow with membrane forces, some steps old.
template <class Real>
OneBlock<Real> flowing(const Lattice& lattice) {
  OneBlock<Real> block(lattice, TwoFluids<TrtRates<>>{trt_rates(1.0 / 6), trt_rates(5.0 / 6)});
  block.body_force = Vec3(1e-4, 2e-5, -3e-5);
  set_equilibrium(
      block.fluid, [](const Int3& n) { return Vec3(0.02 * swirl(n)); }, block.body_force);
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i)
        for (int a = 0; a < 3; ++a) block.fluid.g[a](i, j, k) = Real(1e-4 * swirl({k, i, j})[a]);
  for (int n = 0; n < 7; ++n) block.step();
  return block;
}

template <class Real>
void expect_the_next_steps_velocity(const Lattice& lattice) {
  OneBlock<Real> block = flowing<Real>(lattice);
  fill_halos(block.fluid);
  std::vector<NodeFlow> seen;
  const Int3& n = lattice.size;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) seen.push_back(flow_at(block.fluid, block.body_force, {i, j, k}));
  block.step();
  std::size_t node = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i, ++node)
        for (int a = 0; a < 3; ++a)
          ASSERT_EQ(seen[node].u[a], double(block.fluid.u[a](i, j, k))) << i << " " << j << " " << k << " " << a;
}

TEST(ObservedFlow, IsTheVelocityOfTheNextStep) {
  for (const auto& periodic :
       {std::array{true, false, false}, std::array{true, true, true}, std::array{false, false, true}}) {
    expect_the_next_steps_velocity<double>({{19, 5, 6}, periodic});
    expect_the_next_steps_velocity<float>({{19, 5, 6}, periodic});
  }
}

TEST(ObservedFlow, HasTheMassOfTheState) {
  OneBlock<double> block = flowing<double>({{19, 5, 6}, {true, false, false}});
  fill_halos(block.fluid);
  double seen = 0, held = 0;
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 19; ++i) {
        seen += flow_at(block.fluid, block.body_force, {i, j, k}).rho_1;
        for (int q = 0; q < Q; ++q) held += block.fluid.f.at(q, i, j, k);
      }
  EXPECT_NEAR(seen, held, 1e-13);  // rounding of 570 sums of terms below 1e-2
}

}  // namespace
}  // namespace rouleau
