// SPDX-License-Identifier: BSD-3-Clause
// The correction removes tails, fills holes, leaves smooth bodies alone and knows walls from other borders.
#include "interior/correction.hpp"

#include <gtest/gtest.h>

#include <random>

#include "interior/analytic.hpp"
#include "meshes.hpp"

namespace rouleau {
namespace {

using testing::cut;
using testing::cuts;
using testing::differences;
using testing::differences_on_block;
using testing::fill;
using testing::fill_halo;
using testing::flags_on;
using testing::whole;

const Lattice open_box{{24, 22, 20}, {true, true, true}};
const Lattice channel{{24, 22, 20}, {true, false, false}};
const Lattice closed_box{{24, 22, 20}, {false, false, false}};

Corrections correct(Flags& flags, const Lattice& lattice) {
  fill_halo(flags, lattice);
  return Correction(lattice, whole(lattice)).apply(flags);
}

Flags ball(const Lattice& lattice, const Vec3& centre, double radius) {
  const Body body{Body::Shape::ellipsoid, Vec3::Constant(radius), centre, Eigen::Matrix3d::Identity()};
  Flags flags = flags_on(whole(lattice));
  flag_bodies(std::span(&body, 1), lattice, whole(lattice), flags);
  return flags;
}

Flags noise(const Lattice& lattice, unsigned seed) {
  Flags flags = flags_on(whole(lattice));
  std::mt19937 random(seed);
  // Denser in one half than in the other, so that nodes are taken in as well as dropped.
  testing::for_each_node(whole(lattice), 0, [&](int i, int j, int k) {
    flags(i, j, k) = random() % 100 < (i < lattice.size[0] / 2 ? 30U : 70U);
  });
  return flags;
}

TEST(Correction, LeavesASmoothBodyAlone) {
  Flags flags = ball(open_box, {11.3, 10.8, 9.6}, 7.4);
  const Corrections changed = correct(flags, open_box);
  EXPECT_EQ(changed.activated + changed.deactivated, 0);
}

TEST(Correction, RemovesATailBehindACell) {
  const Flags clean = ball(open_box, {11.3, 10.8, 9.6}, 6.4);
  Flags flags = clean;
  for (int i = 19; i < 24; ++i) flags(i, 10, 9) = flags(i, 11, 9) = 1;  // one row by two, apart from the ball
  const Corrections changed = correct(flags, open_box);
  EXPECT_EQ(changed.deactivated, 10);
  EXPECT_EQ(changed.activated, 0);
  EXPECT_EQ(differences(flags, clean, whole(open_box)), 0);
}

TEST(Correction, FillsHolesInACell) {
  const Flags clean = ball(open_box, {11.3, 10.8, 9.6}, 6.4);
  Flags flags = clean;
  flags(11, 10, 9) = flags(12, 10, 9) = flags(9, 12, 11) = 0;
  const Corrections changed = correct(flags, open_box);
  EXPECT_EQ(changed.activated, 3);
  EXPECT_EQ(changed.deactivated, 0);
  EXPECT_EQ(differences(flags, clean, whole(open_box)), 0);
}

/// The rule as the paper words it, node by node, in Table 1's own numbers.
Flags corrected_slowly(const Flags& flags, const Lattice& lattice) {
  Flags next = flags;
  testing::for_each_node(whole(lattice), 0, [&](int i, int j, int k) {
    int neighbours = 0, active = 0;
    for (int c = -1; c <= 1; ++c)
      for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
          if (a == 0 && b == 0 && c == 0) continue;
          const Int3 n{lattice.wrap(0, i + a), lattice.wrap(1, j + b), lattice.wrap(2, k + c)};
          if (!lattice.contains(0, n[0]) || !lattice.contains(1, n[1]) || !lattice.contains(2, n[2])) continue;
          ++neighbours;
          active += flags(n[0], n[1], n[2]);
        }
    const auto [a, d] = neighbours == 26   ? std::pair(8, 18)
                        : neighbours == 17 ? std::pair(5, 12)
                        : neighbours == 11 ? std::pair(3, 8)
                                           : std::pair(2, 5);
    next(i, j, k) = flags(i, j, k) ? active >= a : active >= d;
  });
  return next;
}

TEST(Correction, FollowsTableOneAtWallsEdgesAndCorners) {
  for (const Lattice& lattice : {open_box, channel, closed_box})
    for (unsigned seed = 0; seed < 3; ++seed) {
      Flags flags = noise(lattice, seed);
      const Flags before = flags, wanted = corrected_slowly(flags, lattice);
      const Corrections changed = correct(flags, lattice);
      EXPECT_EQ(differences(flags, wanted, whole(lattice)), 0);
      EXPECT_EQ(changed.activated - changed.deactivated, count_inside(flags) - count_inside(before));
      EXPECT_EQ(changed.activated + changed.deactivated, differences(flags, before, whole(lattice)));
      EXPECT_GT(changed.activated, 0);
      EXPECT_GT(changed.deactivated, 0);
    }
}

TEST(Correction, IsTheSameOnAnyCut) {
  for (const Lattice& lattice : {open_box, channel, closed_box}) {
    const Flags before = noise(lattice, 5);
    Flags one = before;
    const Corrections all = correct(one, lattice);
    for (const Int3& parts : cuts()) {
      Corrections sum;
      for (const Block& block : cut(lattice, parts)) {
        Flags part = flags_on(block);
        fill(part, lattice, block, std::uint8_t{1}, [&](const Int3& n) { return before(n[0], n[1], n[2]); });
        const Corrections some = Correction(lattice, block).apply(part);
        sum.activated += some.activated;
        sum.deactivated += some.deactivated;
        EXPECT_EQ(differences_on_block(part, one, block), 0);
      }
      EXPECT_EQ(sum.activated, all.activated);
      EXPECT_EQ(sum.deactivated, all.deactivated);
    }
  }
}

}  // namespace
}  // namespace rouleau
