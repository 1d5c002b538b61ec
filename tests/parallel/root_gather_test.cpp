// SPDX-License-Identifier: BSD-3-Clause
// A cut lattice comes together on rank 0, thinned or not.
#include "parallel/root_gather.hpp"

#include <gtest/gtest.h>

#include "base/thinning.hpp"
#include "parallel/decomposition.hpp"

namespace rouleau {
namespace {

const Lattice lattice{{26, 25, 24}, {true, false, false}};

TEST(Thinning, LeavesTheMultiplesOfTheStride) {
  EXPECT_EQ(thinned(Int3{1, 6, 7}, 3), (Int3{1, 2, 3}));
  const Block left = thinned(Block{{4, 3, 7}, {2, 3, 1}}, 3);
  EXPECT_EQ(left.begin, (Int3{2, 1, 3}));
  EXPECT_EQ(left.size, (Int3{0, 1, 0}));
  std::vector<Int3> nodes;
  each_thinned_node({{5, 0, 1}, {6, 1, 4}}, 3, [&](int i, int j, int k) { nodes.push_back({i, j, k}); });
  EXPECT_EQ(nodes, (std::vector<Int3>{{1, 0, 2}, {4, 0, 2}}));
}

TEST(RootGather, PutsEveryNodeInItsPlace) {
  const Communicator comm;
  const Block block = Decomposition(lattice, comm).block();
  for (const int stride : {1, 2, 3, 7, 20}) {
    std::vector<double> own;
    each_thinned_node(block, stride, [&](int i, int j, int k) {
      for (const int v : {block.begin[0] + i, block.begin[1] + j, block.begin[2] + k}) own.push_back(v);
    });
    const Int3 size = thinned(lattice.size, stride);
    const RootGather root(comm, {size, lattice.periodic}, thinned(block, stride));
    const std::vector<double> whole = root.gather(own, 3);
    if (!comm.is_root()) {
      EXPECT_TRUE(whole.empty());
      continue;
    }
    std::vector<double> expected;
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i)
          for (const int v : {i, j, k}) expected.push_back(stride * v);
    EXPECT_EQ(whole, expected) << stride;
  }
}

}  // namespace
}  // namespace rouleau
