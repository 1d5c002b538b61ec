// SPDX-License-Identifier: BSD-3-Clause
// The step allocates nothing: operator new is replaced in this program by one that counts.
#include <gtest/gtest.h>

#include "fluid/controller.hpp"
#include "fluid/flow_rate.hpp"
#include "support/counted_allocations.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

using testing::allocations;

TEST(FluidAllocation, HappensOnlyAtConstruction) {
  const long at_start = allocations;
  testing::OneBlock<float> block({{20, 6, 5}, {true, false, false}}, testing::two_trt(1.0 / 6, 5.0 / 6));
  const MeanVelocityController controller(1e-3, 100, 10);
  ControllerState state = controller.start(0);
  block.inside(3, 3, 3) = 1;
  EXPECT_GT(allocations, at_start);
  const long before = allocations;
  for (int n = 0; n < 3; ++n) {
    block.step();
    controller.update(state, mean_velocity(momentum_fixed_point(block.fluid, 0), 600, state.force));
    (void)check_speed(block.fluid, 0.1);
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace rouleau
