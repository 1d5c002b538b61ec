// SPDX-License-Identifier: BSD-3-Clause
// A cell at rest stays at rest, or does not: the instability of the narrow kernels and its cure
// (studies/safe-combinations), at four times the paper's time step with its moduli.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/simulation.hpp"
#include "storage/file_system.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau {
namespace {

using testing::set_content;
using testing::TemporaryDirectory;

const char* const small_cell_in_a_box =
    "[channel]\nlength_x_um = 6\nlength_y_um = 6\nlength_z_um = 5\nboundary_y = periodic\nboundary_z = periodic\n"
    "[flow]\ndriving = rest\n"
    "[cell]\nradius_um = 2\nsubdivisions = 3\n"
    "[time]\nend_time_s = 1\n[bounds]\nunsafe_combination = run\n"
    "[numerics]\nnode_spacing_um = 1/3\ntime_step_us = 50/81\ntau_plasma = 2.5\n";

/// Largest velocity of a vertex after 600 steps; infinite if the cell was lost before.
double speed_left(const std::string& numerics) {
  const TemporaryDirectory directory;
  set_content(directory.path() / "run.ini", small_cell_in_a_box + numerics);
  const Setup setup = set_up(directory.path() / "run.ini", posix_file_system());
  const Communicator comm;
  const Decomposition decomposition(setup.lattice.lattice, comm);
  const auto simulation = make_simulation(setup, comm, decomposition);
  simulation->start();
  try {
    for (int step = 0; step < 600; ++step) simulation->step();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics) << error.what();
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  const VectorArray& U = simulation->cells().U;
  for (std::size_t v = 0; v < U.size(); ++v) largest = std::max(largest, std::hypot(U.x[v], U.y[v], U.z[v]));
  return largest;
}

// What moves the cell is its bending energy, by less than 1e-3 node spacings a step.
constexpr double slow = 1e-3;

TEST(CellAtRest, IsTornByTheNarrowKernelsUnderEuler) { EXPECT_GT(speed_left("kernel = 2-point\n"), 10 * slow); }
TEST(CellAtRest, StaysWithTheNarrowKernelsUnderAveragedAdvection) {
  EXPECT_LT(speed_left("kernel = 2-point\nadvection = averaged\n"), slow);
  EXPECT_LT(speed_left("kernel = 3-point\nadvection = averaged\n"), slow);
}
TEST(CellAtRest, StaysWithTheWideKernel) { EXPECT_LT(speed_left("kernel = 4-point\n"), slow); }

}  // namespace
}  // namespace rouleau
