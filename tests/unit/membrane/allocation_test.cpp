// SPDX-License-Identifier: BSD-3-Clause
// What runs each step takes no memory from the heap.
#include <gtest/gtest.h>

#include <vector>

#include "base/grid.hpp"
#include "membrane/measures.hpp"
#include "membrane/membrane_forces.hpp"
#include "membrane/mesh_health.hpp"
#include "membrane/volume.hpp"
#include "membrane/wrap.hpp"
#include "sample_cells.hpp"
#include "support/counted_allocations.hpp"

namespace rouleau {
namespace {

using testing::allocations;

TEST(MembraneAllocation, NothingIsAllocatedInAStep) {
  Cells cells = test::one_cell(red_blood_cell(3, 8));
  MembraneForces forces(cells);
  VolumeShift shift(cells);
  MeshHealth health(cells);
  Lattice lattice;
  lattice.size = {16, 20, 20};
  std::vector<std::uint8_t> needed(cells.vertices(), 0);
  for (std::size_t v = 0; v < needed.size(); v += 7) needed[v] = 1;
  const Moduli moduli{.kappa_S = 1, .kappa_A = 100, .kappa_B = 1};

  const long before = allocations;
  for (int step = 0; step < 3; ++step) {
    forces.compute(cells, moduli);
    forces.compute(cells, moduli, needed);
    for (double& x : cells.X.x) x = 1.0001 * x + 9;
    shift.restore(cells);
    wrap_cells(cells, lattice);
    EXPECT_FALSE(health.find_fault(cells).has_value());
    EXPECT_GT(measure(cells, 0).volume + forces.energy(cells, moduli).bending, 0);
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(before, 0);  // the counter counts
}

TEST(MembraneAllocation, ARunWithoutCellsHasNothingToDo) {
  Cells cells = assemble({});
  MembraneForces forces(cells);
  forces.compute(cells, {.kappa_S = 1, .kappa_A = 100, .kappa_B = 1});
  EXPECT_EQ(forces.energy(cells, {.kappa_S = 1, .kappa_A = 100, .kappa_B = 1}).bending, 0);
  EXPECT_EQ(VolumeShift(cells).restore(cells), 0);
  EXPECT_FALSE(MeshHealth(cells).find_fault(cells).has_value());
}

}  // namespace
}  // namespace rouleau
