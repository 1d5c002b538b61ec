// SPDX-License-Identifier: BSD-3-Clause
// The controller on the first-order plant that it is designed for, and on channels.
#include "fluid/controller.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "fluid/developed.hpp"
#include "fluid/flow_rate.hpp"
#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

struct Response {
  double largest = 0, last = 0, settled_after = 0;
};

/// du/dt = G - friction u / T, in exact steps of the interval.
Response run_plant(const MeanVelocityController& controller, double u, double time_constant, double friction,
                   int updates) {
  ControllerState state = controller.start(u);
  Response response;
  const double T = time_constant / friction;
  for (int n = 1; n <= updates; ++n) {
    controller.update(state, u);
    const double steady = state.force * T;
    u = steady + (u - steady) * std::exp(-controller.interval() / T);
    response.largest = std::max(response.largest, u);
    if (std::abs(u - 1e-3) > 1e-5) response.settled_after = n * controller.interval();
  }
  response.last = u;
  return response;
}

TEST(FluidController, ReachesTheTargetFromRestWithoutOvershoot) {
  const Response response = run_plant(MeanVelocityController(1e-3, 500, 10), 0, 500, 1, 1000);
  EXPECT_NEAR(response.last, 1e-3, 1e-12);
  // The law is exact for continuous control; holding the force for 10 of 250 steps costs a few parts in a thousand.
  EXPECT_LT(response.largest, 1.005e-3);
  EXPECT_LT(response.settled_after, 250 * 5);  // exp(-5) < 0.01
}

TEST(FluidController, LeavesDevelopedFlowAlone) {
  const MeanVelocityController controller(1e-3, 500, 10);
  ControllerState state = controller.start(1e-3);
  for (int n = 0; n < 100; ++n) controller.update(state, 1e-3);
  EXPECT_DOUBLE_EQ(state.force, 1e-3 / 500);
}

TEST(FluidController, FirstUpdateFindsTheForceOfTheStart) {
  const MeanVelocityController controller(1e-3, 500, 10);
  const ControllerState start = controller.start(3e-4);
  ControllerState state = start;
  controller.update(state, 3e-4);
  EXPECT_EQ(state.force, start.force);
}

TEST(FluidController, MakesUpForTheFrictionOfACell) {
  const Response response = run_plant(MeanVelocityController(1e-3, 500, 10), 1e-3, 500, 1.08, 2000);
  EXPECT_NEAR(response.last, 1e-3, 1e-12);
  EXPECT_LT(response.largest, 1.001e-3);
}

TEST(FluidController, StaysDampedWhenUpdatesAreRare) {
  const Response response = run_plant(MeanVelocityController(1e-3, 500, 400), 0, 500, 1, 1000);
  EXPECT_NEAR(response.last, 1e-3, 1e-9);
  EXPECT_LT(response.largest, 1.03e-3);
}

TEST(FluidController, DoesNotWindUpWhileTheForceIsAtItsLimit) {
  const MeanVelocityController controller(1e-3, 500, 10);
  ControllerState blocked = controller.start(0), fresh = blocked;
  for (int n = 0; n < 100000; ++n) controller.update(blocked, -1e-2);
  EXPECT_DOUBLE_EQ(blocked.force, controller.largest_force());
  EXPECT_LE(blocked.integral, controller.largest_force());
  controller.update(fresh, 0);
  EXPECT_LT(fresh.force, controller.largest_force());
}

TEST(FluidController, DrivesBackwardsAsWell) {
  const MeanVelocityController forward(1e-3, 500, 10), backward(-1e-3, 500, 10);
  EXPECT_EQ(forward.start(2e-4).force, -backward.start(-2e-4).force);
}

TEST(FluidController, RefusesBadSettings) {
  EXPECT_THROW(MeanVelocityController(0, 500, 10), Error);
  EXPECT_THROW(MeanVelocityController(std::nan(""), 500, 10), Error);
  EXPECT_THROW(MeanVelocityController(1e-3, 0, 10), Error);
  EXPECT_THROW(MeanVelocityController(1e-3, 500, 0), Error);
}

struct ChannelResponse {
  double overshoot = 0, last_error = 0, last_force = 0;
};

/// An empty channel from rest. A quarter of the paper's: 12 x 10 nodes.
template <class Real>
ChannelResponse run_channel(double target, int steps) {
  const Lattice lattice{{4, 12, 10}, {true, false, false}};
  const double nu = 1.0 / 6;
  testing::OneBlock<Real> block(lattice, testing::one_trt(nu));
  const MeanVelocityController controller(target, DevelopedFlow(lattice).mean() / nu, 5);
  ControllerState state = controller.start(0);
  set_uniform(block.fluid, Vec3::Zero(), Vec3(state.force, 0, 0));
  ChannelResponse response;
  for (int n = 0; n < steps; ++n) {
    const double mean = mean_velocity(momentum_fixed_point(block.fluid, 0), lattice.nodes(), state.force);
    if (n % controller.interval() == 0) controller.update(state, mean);
    block.body_force[0] = state.force;
    block.step();
    response.overshoot = std::max(response.overshoot, mean / target - 1);
    response.last_error = std::abs(mean / target - 1);
    response.last_force = state.force;
  }
  return response;
}

TEST(FluidController, HoldsAnEmptyChannelInDouble) {
  const ChannelResponse response = run_channel<double>(7e-4, 2000);
  EXPECT_LT(response.overshoot, 0.04);   // the channel has faster modes than the one that the controller knows
  EXPECT_LT(response.last_error, 1e-7);  // half a fixed-point unit a node is 1e-8 of the target
  // The force of the series, within the error of 10 nodes across (second order: 0.6 / 10^2).
  const double empty = 7e-4 / 6 / DevelopedFlow(12, 10).mean();
  EXPECT_NEAR(response.last_force / empty, 1, 0.01);
}

TEST(FluidController, HoldsAnEmptyChannelInSingle) {
  const ChannelResponse response = run_channel<float>(7e-4, 2000);
  EXPECT_LT(response.overshoot, 0.04);
  EXPECT_LT(response.last_error, 1e-6);
}

}  // namespace
}  // namespace rouleau
