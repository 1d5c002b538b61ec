// SPDX-License-Identifier: BSD-3-Clause
// One copy that streams by renumbering: where the values stand, and that standing elsewhere changes nothing.
#include "fluid/populations.hpp"

#include <gtest/gtest.h>

#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

Populations<double> numbered(const Int3& size) {
  Populations<double> f(size);
  for (int q = 0; q < Q; ++q)
    for (int k = -1; k <= size[2]; ++k)
      for (int j = -1; j <= size[1]; ++j)
        for (int i = -1; i <= size[0]; ++i) f.at(q, i, j, k) = i + 10 * j + 100 * k + 1000 * q;
  return f;
}

TEST(FluidPopulations, AdvanceMovesEachDirectionByItsOwnRows) {
  Populations<double> f = numbered({5, 4, 3});
  f.advance();
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = -1; i <= 5; ++i)
          ASSERT_EQ(f.at(q, i, j, k), i + 10 * (j - c_q[q][1]) + 100 * (k - c_q[q][2]) + 1000 * q);
}

TEST(FluidPopulations, StraightenedOnesStandWhereTheLayoutSays) {
  Populations<double> f = numbered({5, 4, 3});
  for (int n = 0; n < 17; ++n) f.advance();
  const Populations<double> turned = f;
  f.straighten();
  for (int q = 0; q < Q; ++q)
    for (int k = -1; k <= 3; ++k)
      for (int j = -1; j <= 4; ++j)
        for (int i = -1; i <= 5; ++i) {
          ASSERT_EQ(f.at(q, i, j, k), turned.at(q, i, j, k));
          ASSERT_EQ(f.direction(q)[f.layout.index(i, j, k)], turned.at(q, i, j, k));
        }
}

TEST(FluidPopulations, StraighteningBetweenStepsChangesNoBits) {
  const Lattice lattice{{19, 5, 4}, {true, false, true}};
  testing::OneBlock<float> plain(lattice, testing::one_trt(0.2)), straightened(lattice, testing::one_trt(0.2));
  for (auto* block : {&plain, &straightened})
    set_equilibrium(
        block->fluid, [](const Int3& n) { return Vec3(0.02 * testing::swirl(n)); }, Vec3::Zero());
  for (int n = 0; n < 9; ++n) {
    plain.step();
    straightened.step();
    straightened.fluid.f.straighten();
  }
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 19; ++i) ASSERT_EQ(plain.fluid.f.at(q, i, j, k), straightened.fluid.f.at(q, i, j, k));
}

TEST(FluidPopulations, TakeOneCopyAndLittleElse) {
  // What a node needs: 19 populations, 3 velocities, 3 forces. The padding of rows and halos counts against us.
  const Int3 size{128, 36, 30};
  const Fluid<float> fluid({size, {true, false, false}}, {{0, 0, 0}, size});
  std::size_t elements = fluid.f.data.size() + fluid.inside_row.size();
  for (int a = 0; a < 3; ++a)
    elements += fluid.u[static_cast<std::size_t>(a)].data.size() + fluid.g[static_cast<std::size_t>(a)].data.size();
  EXPECT_LT(static_cast<double>(elements), 1.5 * (19 + 3 + 3) * 128 * 36 * 30);
}

}  // namespace
}  // namespace rouleau
