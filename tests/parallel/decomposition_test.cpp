// SPDX-License-Identifier: BSD-3-Clause
// The blocks cover the lattice once; what cannot be cut is refused.
#include "parallel/decomposition.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace rouleau {
namespace {

const Lattice channel{{40, 18, 15}, {true, false, false}};

TEST(Decomposition, BlocksCoverEveryNodeOnce) {
  const Communicator comm;
  const Decomposition d(channel, comm);
  std::vector<std::int64_t> owners(static_cast<std::size_t>(channel.nodes()));
  const Block& b = d.block();
  for (int k = b.begin[2]; k < b.begin[2] + b.size[2]; ++k)
    for (int j = b.begin[1]; j < b.begin[1] + b.size[1]; ++j)
      for (int i = b.begin[0]; i < b.begin[0] + b.size[0]; ++i)
        ++owners[static_cast<std::size_t>(i + channel.size[0] * (j + channel.size[1] * k))];
  comm.sum(owners.data(), static_cast<int>(owners.size()));
  for (const auto n : owners) ASSERT_EQ(n, 1);
}

TEST(Decomposition, NeighbourRelationIsMutual) {
  const Communicator comm;
  const Decomposition d(channel, comm);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::int64_t> high(static_cast<std::size_t>(comm.size())), low(high);
    high[static_cast<std::size_t>(comm.rank())] = d.neighbour(axis, 1);
    low[static_cast<std::size_t>(comm.rank())] = d.neighbour(axis, 0);
    comm.sum(high.data(), comm.size());
    comm.sum(low.data(), comm.size());
    for (int r = 0; r < comm.size(); ++r) {
      const auto up = high[static_cast<std::size_t>(r)];
      if (up >= 0)
        EXPECT_EQ(low[static_cast<std::size_t>(up)], r);
      else
        EXPECT_FALSE(channel.periodic[static_cast<std::size_t>(axis)]);
    }
  }
}

TEST(Decomposition, CutsAcrossTheChannelBeforeAlongIt) {
  const Lattice paper{{128, 36, 30}, {true, false, false}};
  EXPECT_EQ(choose_ranks(paper, 2), (Int3{1, 2, 1}));
  EXPECT_EQ(choose_ranks(paper, 4), (Int3{1, 2, 2}));
}

TEST(Decomposition, RefusesBlocksThinnerThanTheHalo) {
  const Communicator comm;
  const Lattice thin{{3, 3, 3}, {true, true, true}};
  if (comm.size() == 1)
    EXPECT_NO_THROW(Decomposition(thin, comm));
  else
    EXPECT_THROW(Decomposition(thin, comm), Error);
}

TEST(Decomposition, RefusesACutThatNeedsAnotherNumberOfRanks) {
  const Communicator comm;
  EXPECT_THROW(Decomposition(channel, comm, {comm.size() + 1, 1, 1}), Error);
}

}  // namespace
}  // namespace rouleau
