// SPDX-License-Identifier: BSD-3-Clause
// The whole coupled step takes no memory from the heap, on any number of ranks: operator new is replaced in this
// program by one that counts. (What MPI takes for its messages it takes by malloc.)
#include <gtest/gtest.h>

#include "run/simulation.hpp"
#include "storage/file_system.hpp"
#include "support/counted_allocations.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau {
namespace {

using testing::allocations;

/// Long enough for the control of the mean velocity, the correction and the seam to have their turn.
void allocates_nothing(const std::string& numerics) {
  const testing::TemporaryDirectory directory;
  testing::set_content(directory.path() / "run.ini",
                       "[fluid]\nlambda = 5\n"
                       "[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
                       "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
                       "[cell]\nsubdivisions = 3\nposition_x_um = 15\noffset_y_um = 0.5\nrotation_axis = 0 1 0\n"
                       "rotation_angle_deg = 40\n"
                       "[membrane]\nbending_modulus_J = 1e-18\n"
                       "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\ncorrection_interval = 7\n" +
                           numerics + "[time]\nend_time_s = 1\n");
  const Setup setup = set_up(directory.path() / "run.ini", posix_file_system());
  const Communicator comm;
  const Decomposition decomposition(setup.lattice.lattice, comm);
  const auto simulation = make_simulation(setup, comm, decomposition);
  simulation->start();
  simulation->step();
  const long before = allocations;
  for (int n = 0; n < 200; ++n) simulation->step();
  EXPECT_EQ(allocations, before);
}

TEST(StepAllocation, NothingInSingleWithTheFourPointKernel) { allocates_nothing("kernel = 4-point\n"); }
TEST(StepAllocation, NothingInDoubleWithTheTwoPointKernel) {
  allocates_nothing("precision = double\nkernel = 2-point\nadvection = averaged\n");
}
TEST(StepAllocation, NothingWithFaceNormalsAndMrt) { allocates_nothing("tracking = face_normals\ncollision = mrt\n"); }

}  // namespace
}  // namespace rouleau
