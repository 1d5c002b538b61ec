// SPDX-License-Identifier: BSD-3-Clause
// Spreading conserves, and its bits do not depend on the cut.
#include "coupling/spread.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "points.hpp"
#include "support/blocks.hpp"

namespace rouleau {
namespace {

using testing::anywhere;
using testing::cut;
using testing::cuts;
using testing::for_each_node;
using testing::points;
using ::testing::Values;
using testing::whole;

const Lattice channel{{14, 9, 8}, {true, false, false}};
const Lattice open_box{{12, 11, 10}, {true, true, true}};
const Lattice long_channel{{150, 9, 8}, {true, false, false}};  // rows of five segments

template <class Real>
VectorField<Real> zero_field(const Block& block, int halo) {
  return {Field<Real>(block.size, halo), Field<Real>(block.size, halo), Field<Real>(block.size, halo)};
}

template <class Real>
VectorField<Real> spread_on(const Lattice& lattice, const Block& block, Kernel kernel, const Cells& cells) {
  VectorField<Real> g = zero_field<Real>(block, 1);
  Stencils s(kernel, lattice, block, cells.vertices());
  find_stencils(cells, s);
  spread(cells.F, s, g);
  return g;
}

template <class Real>
Vec3 total_on(const VectorField<Real>& g, const Block& block) {
  Vec3 sum = Vec3::Zero();
  for_each_node(block, 0, [&](int i, int j, int k) { sum += Vec3(g[0](i, j, k), g[1](i, j, k), g[2](i, j, k)); });
  return sum;
}

class Spread : public ::testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(Kernels, Spread, Values(Kernel::two_point, Kernel::three_point, Kernel::four_point));

TEST_P(Spread, ConservesTotalForceUpToTheWalls) {
  for (const Lattice& lattice : {channel, open_box}) {
    Cells cells = points(anywhere(lattice, 1000, 11));
    testing::random_forces(cells, 12);
    const Vec3 wanted = testing::total(cells.F);
    const Vec3 exact = total_on(spread_on<double>(lattice, whole(lattice), GetParam(), cells), whole(lattice));
    EXPECT_LT((exact - wanted).norm(), 1e-12);  // 1000 forces of order 1: rounding of the sums
    const Vec3 coarse = total_on(spread_on<float>(lattice, whole(lattice), GetParam(), cells), whole(lattice));
    EXPECT_LT((coarse - wanted).norm(), 1e-3);  // 1000 x 64 additions at 6e-8, mostly of random sign
  }
}

TEST_P(Spread, ConservesTorqueAwayFromWalls) {
  std::mt19937 random(13);
  std::vector<Vec3> positions;
  for (int v = 0; v < 300; ++v) positions.push_back(testing::random_vector(random, 2.0, 7.0));
  Cells cells = points(positions);
  testing::random_forces(cells, 14);
  Vec3 wanted = Vec3::Zero(), found = Vec3::Zero();
  for (std::size_t v = 0; v < cells.vertices(); ++v) wanted += at(cells.X, v).cross(at(cells.F, v));
  const auto g = spread_on<double>(open_box, whole(open_box), GetParam(), cells);
  for_each_node(whole(open_box), 0, [&](int i, int j, int k) {
    found += Vec3(i, j, k).cross(Vec3(g[0](i, j, k), g[1](i, j, k), g[2](i, j, k)));
  });
  EXPECT_LT((found - wanted).norm(), 1e-11);  // first moments vanish to rounding; arms of up to 12, 300 forces
}

/// phi(r) of one axis by the kernel's definition, summed over all images and mirror images of a node.
double share(Kernel kernel, double X, int node, const Lattice& lattice, int axis) {
  const auto phi = [&](double at_node) {
    return with_kernel(kernel, [&](auto law) {
      using Phi = decltype(law);
      const double first = Phi::first_node(X), a = at_node - first;
      return a < 0 || a >= Phi::width ? 0.0 : Phi::weights(X - first)[static_cast<std::size_t>(a)];
    });
  };
  const int n = lattice.size[axis];
  if (!lattice.periodic[axis]) return phi(node) + phi(-1 - node) + phi(2 * n - 1 - node);
  double sum = 0;
  for (int period = -2; period <= 2; ++period) sum += phi(node + period * n);
  return sum;
}

TEST_P(Spread, EqualsTheSumOverAllNodesAndImages) {
  Cells cells = points(anywhere(channel, 60, 15));
  testing::random_forces(cells, 16);
  const auto g = spread_on<double>(channel, whole(channel), GetParam(), cells);
  for_each_node(whole(channel), 0, [&](int i, int j, int k) {
    Vec3 slow = Vec3::Zero();
    for (std::size_t v = 0; v < cells.vertices(); ++v) {
      const Vec3 X = at(cells.X, v);
      slow += share(GetParam(), X[0], i, channel, 0) * share(GetParam(), X[1], j, channel, 1) *
              share(GetParam(), X[2], k, channel, 2) * at(cells.F, v);
    }
    EXPECT_LT((Vec3(g[0](i, j, k), g[1](i, j, k), g[2](i, j, k)) - slow).norm(), 1e-14);
  });
}

template <class Real>
void expect_same_bits_on_any_cut(const Lattice& lattice, Kernel kernel) {
  Cells cells = points(anywhere(lattice, 3000, 17));  // several vertices a node: the order of additions matters
  testing::random_forces(cells, 18);
  const auto one = spread_on<Real>(lattice, whole(lattice), kernel, cells);
  for (const Int3& parts : cuts())
    for (const Block& block : cut(lattice, parts)) {
      const auto part = spread_on<Real>(lattice, block, kernel, cells);
      for (std::size_t c = 0; c < 3; ++c)
        for_each_node(block, 0, [&](int i, int j, int k) {
          ASSERT_EQ(part[c](i, j, k), one[c](block.begin[0] + i, block.begin[1] + j, block.begin[2] + k));
        });
    }
}

TEST_P(Spread, GivesTheSameBitsOnAnyCut) {
  for (const Lattice& lattice : {channel, open_box}) {
    expect_same_bits_on_any_cut<double>(lattice, GetParam());
    expect_same_bits_on_any_cut<float>(lattice, GetParam());
  }
}

TEST_P(Spread, WritesOwnedNodesOfMarkedSegmentsOnly) {
  for (const Lattice& lattice : {channel, long_channel}) {
    Cells cells = points(anywhere(lattice, 20, 19));
    testing::random_forces(cells, 20);
    for (const Block& block : cut(lattice, {2, 2, 2})) {
      VectorField<double> g = zero_field<double>(block, 2);
      constexpr double untouched = 7;
      for (Field<double>& component : g) std::ranges::fill(component.data, untouched);
      Stencils s(GetParam(), lattice, block, cells.vertices());
      find_stencils(cells, s);
      spread(cells.F, s, g);
      for_each_node(block, 2, [&](int i, int j, int k) {
        const bool is_owned = i >= 0 && j >= 0 && k >= 0 && i < block.size[0] && j < block.size[1] && k < block.size[2];
        if (!is_owned || !(s.rows[s.row(j, k)] >> (i >> s.segment_shift) & 1)) {
          EXPECT_EQ(g[0](i, j, k), untouched) << i << " " << j << " " << k;
        }
      });
    }
  }
}

TEST_P(Spread, IsUndoneByClearing) {
  for (const Lattice& lattice : {channel, long_channel}) {
    VectorField<float> g = zero_field<float>(whole(lattice), 0);
    Stencils s(GetParam(), lattice, whole(lattice), 100);
    for (unsigned seed = 0; seed < 3; ++seed) {
      Cells cells = points(anywhere(lattice, 100, seed));
      testing::random_forces(cells, seed);
      find_stencils(cells, s);
      spread(cells.F, s, g);
      // The stencils may have moved on before the old force is cleared.
      find_stencils(points(anywhere(lattice, 100, seed + 10)), s);
      clear_touched(s, g);
      for (const Field<float>& component : g)
        for (const float value : component.data) ASSERT_EQ(value, 0.0F);
    }
  }
}

TEST_P(Spread, ClearsARowOnceOnly) {
  VectorField<double> g = zero_field<double>(whole(channel), 0);
  Cells cells = points({{5.5, 4.5, 3.5}});
  testing::random_forces(cells, 27);
  Stencils s(GetParam(), channel, whole(channel), 1);
  find_stencils(cells, s);
  spread(cells.F, s, g);
  clear_touched(s, g);
  g[0](5, 4, 3) = 1;  // whatever stands there now is not the spreading's
  clear_touched(s, g);
  EXPECT_EQ(g[0](5, 4, 3), 1);
}

}  // namespace
}  // namespace rouleau
