// SPDX-License-Identifier: BSD-3-Clause
// A lattice cut into blocks gives the same bits as one block; halos are copied by hand here.
#include <gtest/gtest.h>

#include "fluid/flow_rate.hpp"
#include "fluid/initial.hpp"
#include "support/blocks.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

using testing::swirl;

/// Copies into each block's halo, node by node, what the owner of that node holds, but only the directions that an
/// exchange of `directions_out` in phases x, y, z carries: the five that cross the face. All else stays poisoned.
template <class Real>
void exchange_by_hand(std::vector<Fluid<Real>>& blocks) {
  const Lattice& lattice = blocks.front().lattice;
  for (int axis = 0; axis < 3; ++axis)
    for (Fluid<Real>& to : blocks)
      for (int side = 0; side < 2; ++side) {
        const int layer = side == 0 ? -1 : to.block.size[axis];
        const Box box = phase_box(to.f.layout, axis, layer, layer + 1);
        for (int k = box.begin[2]; k < box.end[2]; ++k)
          for (int j = box.begin[1]; j < box.end[1]; ++j)
            for (int i = box.begin[0]; i < box.end[0]; ++i) {
              // The neighbour's local coordinates: those along later axes are owned, those along earlier ones may be
              // halo.
              Int3 node{to.block.begin[0] + i, to.block.begin[1] + j, to.block.begin[2] + k};
              node[axis] = lattice.wrap(axis, node[axis]);
              if (!lattice.contains(axis, node[axis])) continue;
              for (const Fluid<Real>& from : blocks) {
                bool is_neighbour = true;
                for (int a = 0; a < 3; ++a)
                  is_neighbour = is_neighbour && (a == axis ? node[a] >= from.block.begin[a] &&
                                                                  node[a] < from.block.begin[a] + from.block.size[a]
                                                            : from.block.begin[a] == to.block.begin[a]);
                if (!is_neighbour) continue;
                const Int3 source{node[0] - from.block.begin[0], node[1] - from.block.begin[1],
                                  node[2] - from.block.begin[2]};
                for (const int q : directions_out(axis, 1 - side))
                  to.f.at(q, i, j, k) = from.f.at(q, source[0], source[1], source[2]);
              }
            }
      }
}

template <class Real>
void poison_halos(Fluid<Real>& fluid) {
  testing::for_each_node(fluid.block, 1, [&](int i, int j, int k) {
    const Int3& n = fluid.block.size;
    if (i >= 0 && i < n[0] && j >= 0 && j < n[1] && k >= 0 && k < n[2]) return;
    for (int q = 0; q < Q; ++q) fluid.f.at(q, i, j, k) = Real(std::nan(""));
  });
}

template <class Real>
void expect_same_bits_however_cut(const std::array<bool, 3>& periodic, const Collision& collision) {
  const Lattice lattice{{23, 7, 8}, periodic};
  const Vec3 body_force(1e-4, 0, 2e-5);
  const auto run = [&](const std::vector<Block>& parts) {
    std::vector<Fluid<Real>> blocks;
    std::vector<Field<std::uint8_t>> inside;
    for (const Block& part : parts) {
      Fluid<Real>& fluid = blocks.emplace_back(lattice, part);
      Field<std::uint8_t>& flags = inside.emplace_back(part.size, 1);
      if (!periodic[2]) fluid.wall_velocity[2] = {Vec3(-0.02, 0.01, 0), Vec3(0.03, 0, 0)};
      set_equilibrium(
          fluid, [](const Int3& n) { return Vec3(0.02 * swirl(n)); }, body_force);
      testing::for_each_node(part, 0, [&](int i, int j, int k) {
        const Int3 n{part.begin[0] + i, part.begin[1] + j, part.begin[2] + k};
        flags(i, j, k) = (n[0] / 5 + n[1] / 3 + n[2] / 4) % 2 == 0 ? 1 : 0;
        for (int a = 0; a < 3; ++a) fluid.g[a](i, j, k) = Real(1e-4 * swirl({n[2], n[0], n[1]})[a]);
      });
    }
    for (int n = 0; n < 15; ++n) {
      for (Fluid<Real>& fluid : blocks) poison_halos(fluid);
      exchange_by_hand(blocks);
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        fill_walls(blocks[b]);
        collide_and_stream(blocks[b], collision, inside[b], body_force);
      }
    }
    return blocks;
  };
  const std::vector<Fluid<Real>> one = run({testing::whole(lattice)});
  const auto total = testing::total_momentum(one.front());
  for (const Int3& parts : testing::cuts()) {
    std::array<std::int64_t, 3> sum{};
    for (const Fluid<Real>& fluid : run(testing::cut(lattice, parts))) {
      for (int a = 0; a < 3; ++a) sum[a] += testing::total_momentum(fluid)[a];
      int different = 0;
      testing::for_each_node(fluid.block, 0, [&](int i, int j, int k) {
        const Int3& b = fluid.block.begin;
        for (int q = 0; q < Q; ++q) different += fluid.f.at(q, i, j, k) != one[0].f.at(q, b[0] + i, b[1] + j, b[2] + k);
        for (int a = 0; a < 3; ++a) different += fluid.u[a](i, j, k) != one[0].u[a](b[0] + i, b[1] + j, b[2] + k);
      });
      EXPECT_EQ(different, 0);
    }
    EXPECT_EQ(sum, total);
  }
}

TEST(FluidDecomposition, GivesTheSameBitsInAChannel) {
  expect_same_bits_however_cut<double>({true, false, false}, testing::two_trt(1.0 / 6, 5.0 / 6));
  expect_same_bits_however_cut<float>({true, false, false}, testing::two_trt(1.0 / 6, 5.0 / 6));
}

TEST(FluidDecomposition, GivesTheSameBitsInAPeriodicBox) {
  expect_same_bits_however_cut<double>({true, true, true}, testing::two_trt(1.0 / 6, 5.0 / 6));
  expect_same_bits_however_cut<float>({true, true, true}, testing::two_trt(1.0 / 6, 5.0 / 6));
}

TEST(FluidDecomposition, GivesTheSameBitsInAShearCellWithMrt) {
  const Collision mrt = TwoFluids<MrtRates<>>{mrt_rates(1.0 / 6, 1, 1.2), mrt_rates(5.0 / 6, 1, 1.2)};
  expect_same_bits_however_cut<double>({true, true, false}, mrt);
  expect_same_bits_however_cut<float>({true, true, false}, mrt);
}

TEST(FluidDecomposition, GivesTheSameBitsInAClosedBox) {
  expect_same_bits_however_cut<double>({false, false, false}, testing::two_trt(1.0 / 6, 5.0 / 6));
}

}  // namespace
}  // namespace rouleau
