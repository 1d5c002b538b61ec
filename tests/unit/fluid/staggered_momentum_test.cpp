// SPDX-License-Identifier: BSD-3-Clause
// The lattice keeps more than mass and momentum: what averaged advection (coupling/advect.cpp) must not see.
#include <gtest/gtest.h>

#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

/// Sum over the nodes of (-1)^(coordinate along `axis`) times the momentum along it.
double staggered_momentum(const Fluid<double>& fluid, int axis) {
  const Int3& size = fluid.block.size;
  double sum = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        for (int q = 0; q < Q; ++q)
          sum += (std::array{i, j, k}[axis] % 2 == 0 ? 1 : -1) * c_q[q][axis] * fluid.f.at(q, i, j, k);
  return sum;
}

TEST(StaggeredMomentum, ChangesItsSignInEachStepAndNothingElse) {
  const Lattice lattice{{12, 8, 6}, {true, true, true}};
  testing::OneBlock<double> box(lattice, testing::two_trt(1.0 / 6, 5.0 / 6));
  for (int i = 3; i < 8; ++i)
    for (int j = 2; j < 6; ++j) box.inside(i, j, 3) = 1;  // it holds whatever the viscosities
  const auto alternating = [](const Int3& n) {
    return Vec3(0.01 * testing::swirl(n) + Vec3(n[0] % 2, n[1] % 2, n[2] % 2) * 0.02);
  };
  set_equilibrium(box.fluid, alternating, Vec3::Zero());
  box.step();
  std::array<double, 3> first{};
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = staggered_momentum(box.fluid, axis);
    EXPECT_GT(std::abs(first[axis]), 1);  // 576 nodes of some 0.01
  }
  for (int step = 1; step <= 20; ++step) {
    box.step();
    const double sign = step % 2 == 0 ? 1 : -1;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(staggered_momentum(box.fluid, axis), sign * first[axis], 1e-12 * step) << "round-off of 1e4 terms";
  }
}

}  // namespace
}  // namespace rouleau
