// SPDX-License-Identifier: BSD-3-Clause
// Which block knows which vertex.
#include "coupling/stencils.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "points.hpp"
#include "support/blocks.hpp"

namespace rouleau {
namespace {

using testing::anywhere;
using testing::cut;
using testing::cuts;
using ::testing::HasSubstr;
using testing::points;
using ::testing::Values;
using testing::whole;

const Lattice channel{{14, 9, 8}, {true, false, false}};
const Lattice open_box{{11, 7, 6}, {true, true, true}};
const Lattice closed_box{{7, 6, 9}, {false, false, false}};

/// Whether some node of the stencil that exists is in the block: found by looking at each node.
bool reaches(const Stencils& s, std::size_t v) {
  for (int c = 0; c < s.width; ++c)
    for (int b = 0; b < s.width; ++b)
      for (int a = 0; a < s.width; ++a) {
        const Int3 node{s.first[0][v] + a, s.first[1][v] + b, s.first[2][v] + c};
        bool is_here = true;
        for (int axis = 0; axis < 3; ++axis) {
          const int folded = s.lattice.wrap(axis, node[axis]);
          is_here = is_here && folded >= s.block.begin[axis] && folded < s.block.begin[axis] + s.block.size[axis];
        }
        if (is_here) return true;
      }
  return false;
}

class StencilsOf : public ::testing::TestWithParam<std::tuple<Kernel, const Lattice*>> {
 protected:
  Kernel kernel = std::get<0>(GetParam());
  const Lattice& lattice = *std::get<1>(GetParam());
};

TEST_P(StencilsOf, AVertexIsOwnedByExactlyOneBlock) {
  const Cells cells = points(anywhere(lattice, 2000, 1));
  for (const Int3& parts : cuts()) {
    std::vector<int> owners(cells.vertices());
    for (const Block& block : cut(lattice, parts)) {
      Stencils s(kernel, lattice, block, cells.vertices());
      find_stencils(cells, s);
      for (const std::int32_t v : s.owned) ++owners[static_cast<std::size_t>(v)];
    }
    EXPECT_THAT(owners, ::testing::Each(1));
  }
}

TEST_P(StencilsOf, SpreadsHereWhereANodeOfTheStencilIs) {
  const Cells cells = points(anywhere(lattice, 1000, 2));
  for (const Int3& parts : cuts())
    for (const Block& block : cut(lattice, parts)) {
      Stencils s(kernel, lattice, block, cells.vertices());
      find_stencils(cells, s);
      for (std::size_t v = 0; v < cells.vertices(); ++v) EXPECT_EQ(s.spreads_here[v] != 0, reaches(s, v)) << v;
    }
}

TEST_P(StencilsOf, ListsAreTheMasksInAscendingOrder) {
  const Cells cells = points(anywhere(lattice, 500, 3));
  for (const Block& block : cut(lattice, {2, 2, 2})) {
    Stencils s(kernel, lattice, block, cells.vertices());
    find_stencils(cells, s);
    std::vector<std::int32_t> spreading, owned;
    for (std::int32_t v = 0; v < 500; ++v) {
      if (s.spreads_here[static_cast<std::size_t>(v)]) spreading.push_back(v);
      if (s.owned_here[static_cast<std::size_t>(v)]) owned.push_back(v);
    }
    EXPECT_EQ(s.spreading, spreading);
    EXPECT_EQ(s.owned, owned);
    for (const std::int32_t v : owned) EXPECT_TRUE(s.spreads_here[static_cast<std::size_t>(v)]);
  }
}

TEST_P(StencilsOf, NothingIsAllocatedAfterConstruction) {
  Stencils s(kernel, lattice, whole(lattice), 300);
  const auto addresses = [&] {
    return std::tuple(s.first[0].data(), s.weight[2].data(), s.spreading.data(), s.owned.data(), s.rows.data());
  };
  const auto before = addresses();
  for (unsigned seed = 0; seed < 3; ++seed) find_stencils(points(anywhere(lattice, 300, seed)), s);
  EXPECT_EQ(addresses(), before);
}

INSTANTIATE_TEST_SUITE_P(All, StencilsOf,
                         ::testing::Combine(Values(Kernel::two_point, Kernel::three_point, Kernel::four_point),
                                            Values(&channel, &open_box, &closed_box)));

template <class Phi>
void expect_weights_of(Kernel kernel, const Lattice& lattice) {
  const Cells cells = points(anywhere(lattice, 203, 4));  // not a multiple of any vector
  Stencils s(kernel, lattice, whole(lattice), cells.vertices());
  find_stencils(cells, s);
  for (std::size_t v = 0; v < cells.vertices(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      const double X = at(cells.X, v)[axis];
      const auto weights = Phi::weights(X - Phi::first_node(X));
      const auto first = static_cast<int>(Phi::first_node(X));
      EXPECT_EQ(s.first[axis][v], lattice.wrap(axis, first));
      for (int a = 0; a < Phi::width; ++a) EXPECT_EQ(s.weights(axis, v)[a], weights[static_cast<std::size_t>(a)]);
    }
}

TEST_P(StencilsOf, FirstNodesAndWeightsAreThoseOfTheKernel) {
  with_kernel(kernel, [&](auto phi) { expect_weights_of<decltype(phi)>(kernel, lattice); });
}

TEST_P(StencilsOf, MarkExactlyTheSegmentsWithNodesOfAStencil) {
  const Lattice wide{{40, lattice.size[1], lattice.size[2]}, lattice.periodic};
  const Cells cells = points(anywhere(wide, 25, 5));
  for (const Block& block : cut(wide, {2, 1, 1})) {
    Stencils s(kernel, wide, block, cells.vertices());
    find_stencils(cells, s);
    Array<std::uint8_t> touched(s.rows.size());
    for (std::size_t v = 0; v < cells.vertices(); ++v)
      for (int c = 0; c < s.width; ++c)
        for (int b = 0; b < s.width; ++b)
          for (int a = 0; a < s.width; ++a) {
            Int3 local{s.first[0][v] + a, s.first[1][v] + b, s.first[2][v] + c};
            bool is_here = true;
            for (int axis = 0; axis < 3; ++axis) {
              local[axis] = wide.wrap(axis, local[axis]) - block.begin[axis];
              is_here = is_here && local[axis] >= 0 && local[axis] < block.size[axis];
            }
            if (is_here) touched[s.row(local[1], local[2])] |= 1U << (local[0] >> s.segment_shift);
          }
    EXPECT_EQ(s.rows, touched);
  }
}

TEST(Stencils, MarkTheSegmentsTheyTouch) {
  const Lattice wide{{64, 9, 8}, {true, false, false}};
  Stencils s(Kernel::four_point, wide, whole(wide), 1);
  find_stencils(points({{24.5, 4.5, 3.5}}), s);
  EXPECT_EQ(s.rows[s.row(4, 3)], 0b0010);
  find_stencils(points({{31.5, 4.5, 3.5}}), s);
  EXPECT_EQ(s.rows[s.row(3, 5)], 0b0110);
  EXPECT_EQ(s.rows[s.row(7, 3)], 0);
}

TEST(Stencils, MarkTheRowsTheyTouch) {
  const Cells cells = points({{3.2, 4.7, 2.5}});
  Stencils s(Kernel::two_point, channel, whole(channel), 1);
  find_stencils(cells, s);
  for (int k = 0; k < channel.size[2]; ++k)
    for (int j = 0; j < channel.size[1]; ++j)
      EXPECT_EQ(s.rows[s.row(j, k)] != 0, (j == 4 || j == 5) && (k == 2 || k == 3)) << j << " " << k;
}

TEST(Stencils, ForgetTheRowsOfTheStepBefore) {
  Stencils s(Kernel::two_point, channel, whole(channel), 1);
  find_stencils(points({{3.2, 4.7, 2.5}}), s);
  find_stencils(points({{3.2, 1.7, 2.5}}), s);
  EXPECT_FALSE(s.rows[s.row(4, 2)]);
  EXPECT_TRUE(s.rows[s.row(1, 2)]);
}

std::string error_of(const std::vector<Vec3>& positions, Exit code) {
  const Cells cells = points(positions);
  Stencils s(Kernel::four_point, channel, whole(channel), cells.vertices());
  try {
    find_stencils(cells, s);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "no error";
}

TEST(Stencils, RefuseAVertexBeyondAWallByName) {
  const std::string message = error_of({{1, 1, 1}, {5, 8.75, 3}}, Exit::physics);
  EXPECT_THAT(message, HasSubstr("vertex 1 of cell 0"));
  EXPECT_THAT(message, HasSubstr("high y wall"));
  EXPECT_THAT(message, HasSubstr("(5, 8.75, 3)"));
}

TEST(Stencils, RefuseAPositionThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_of({{1, 1, nan}}, Exit::physics), HasSubstr("vertex 0 of cell 0"));
  EXPECT_THAT(error_of({{nan, 1, 1}}, Exit::physics), HasSubstr("vertex 0 of cell 0"));
  EXPECT_THAT(error_of({{std::numeric_limits<double>::infinity(), 1, 1}}, Exit::physics), HasSubstr("vertex 0"));
}

TEST(Stencils, RefuseALatticeNarrowerThanTheKernel) {
  const Lattice thin{{16, 3, 16}, {true, true, true}};
  EXPECT_NO_THROW(Stencils(Kernel::three_point, thin, whole(thin), 1));
  EXPECT_THROW(Stencils(Kernel::four_point, thin, whole(thin), 1), Error);
}

}  // namespace
}  // namespace rouleau
