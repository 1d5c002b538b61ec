// SPDX-License-Identifier: BSD-3-Clause
// After an exchange every halo node inside the lattice holds what its owner holds, edges and corners included.
#include "parallel/halo.hpp"

#include <gtest/gtest.h>

namespace rouleau {
namespace {

template <class T>
T value_of_node(const Lattice& l, int component, int i, int j, int k) {
  return static_cast<T>(component * 1000003 + l.wrap(0, i) + 101 * (l.wrap(1, j) + 101 * l.wrap(2, k)));
}

template <class T>
void fills_from_owners(const Lattice& lattice, int width) {
  const Communicator comm;
  const Decomposition d(lattice, comm);
  const Block& b = d.block();
  std::array<Field<T>, 2> fields{Field<T>(b.size, width), Field<T>(b.size, width)};
  for (int c = 0; c < 2; ++c) {
    Field<T>& f = fields[static_cast<std::size_t>(c)];
    std::fill(f.data.begin(), f.data.end(), T(-1));
    for (int k = 0; k < b.size[2]; ++k)
      for (int j = 0; j < b.size[1]; ++j)
        for (int i = 0; i < b.size[0]; ++i)
          f(i, j, k) = value_of_node<T>(lattice, c, b.begin[0] + i, b.begin[1] + j, b.begin[2] + k);
  }
  HaloExchange<T> halo(comm, d, fields[0].layout, width, 2);
  const std::array<Rows<T>, 2> rows{fields[0].layout.rows(fields[0].data.data()),
                                    fields[1].layout.rows(fields[1].data.data())};
  halo.exchange(rows);

  const auto exists = [&](int axis, int i) {
    return lattice.periodic[static_cast<std::size_t>(axis)] || lattice.contains(axis, i);
  };
  for (int c = 0; c < 2; ++c)
    for (int k = -width; k < b.size[2] + width; ++k)
      for (int j = -width; j < b.size[1] + width; ++j)
        for (int i = -width; i < b.size[0] + width; ++i) {
          const Int3 g{b.begin[0] + i, b.begin[1] + j, b.begin[2] + k};
          const T got = fields[static_cast<std::size_t>(c)](i, j, k);
          if (exists(0, g[0]) && exists(1, g[1]) && exists(2, g[2]))
            ASSERT_EQ(got, value_of_node<T>(lattice, c, g[0], g[1], g[2])) << i << ' ' << j << ' ' << k;
          else
            ASSERT_EQ(got, T(-1)) << "beyond a wall: " << i << ' ' << j << ' ' << k;
        }
}

TEST(HaloExchange, FillsTwoLayersInAChannel) { fills_from_owners<float>({{40, 18, 15}, {true, false, false}}, 2); }
TEST(HaloExchange, FillsTwoLayersInAPeriodicBox) { fills_from_owners<double>({{25, 24, 26}, {true, true, true}}, 2); }
TEST(HaloExchange, FillsOneLayerBetweenTwoWalls) { fills_from_owners<double>({{25, 24, 26}, {true, true, false}}, 1); }

TEST(HaloExchange, ListedComponentsCrossOnlyTheirFaces) {
  const Communicator comm;
  const Lattice lattice{{24, 24, 24}, {true, true, true}};
  const Decomposition d(lattice, comm);
  const Block& b = d.block();
  Field<double> f(b.size, 1);
  std::fill(f.data.begin(), f.data.end(), 7.0);
  for (int side = 0; side < 2; ++side) f(side == 0 ? -1 : b.size[0], 0, 0) = -1;
  HaloExchange<double>::Components components;
  components[0][1] = {f.layout.rows(f.data.data())};  // towards high x: only the low halo is filled
  HaloExchange<double>(comm, d, f.layout, 1, 1).exchange(components, 0);
  EXPECT_EQ(f(-1, 0, 0), 7.0);
  EXPECT_EQ(f(b.size[0], 0, 0), -1.0);
}

}  // namespace
}  // namespace rouleau
