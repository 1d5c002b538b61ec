// SPDX-License-Identifier: BSD-3-Clause
// What runs each step takes no memory from the heap.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <vector>

#include "base/grid.hpp"
#include "membrane/measures.hpp"
#include "membrane/membrane_forces.hpp"
#include "membrane/mesh_health.hpp"
#include "membrane/volume.hpp"
#include "membrane/wrap.hpp"
#include "sample_cells.hpp"

namespace {

long allocations = 0;

void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace rouleau {
namespace {

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
