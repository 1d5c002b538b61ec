// SPDX-License-Identifier: BSD-3-Clause
// The body force that holds the mean velocity of a channel flow.
#pragma once

namespace rouleau {

/// What a checkpoint must hold of the controller.
struct ControllerState {
  double integral = 0;  ///< force that the past errors have built up
  double force = 0;     ///< body force along x, until the next update
};

/// Proportional-integral control, G = integral + K_p e, d(integral)/dt = K_i e, e = target - mean velocity, of a flow
/// that obeys du/dt = G - u/T, T the time constant of the empty channel. The gains K_p = 2/T_c - 1/T, K_i = 1/T_c^2
/// damp the loop critically; with the integral it starts from, the flow approaches the target like exp(-t/T_c), without
/// overshoot. A cell adds to the friction; the integral takes that up.
class MeanVelocityController {
 public:
  /// `target`: mean velocity; `time_constant`: T = mean velocity over body force of the empty channel, steps
  /// (DevelopedFlow::mean() / nu); `interval`: steps from update to update.
  /// throws Error(bad_input) unless target is finite and not zero, T > 0, interval >= 1
  MeanVelocityController(double target, double time_constant, int interval);

  /// State for a flow that starts with this mean velocity: its force belongs into the initial populations.
  [[nodiscard]] ControllerState start(double mean_velocity) const;
  /// Sets the force of the next `interval` steps from the mean velocity of now. Call it before steps 0, interval,
  /// 2 interval ...; at step 0 it finds the force of `start` again.
  void update(ControllerState& state, double mean_velocity) const;

  [[nodiscard]] int interval() const { return interval_; }
  /// |force| is never larger than this; while it is held there the integral does not grow further.
  [[nodiscard]] double largest_force() const;

 private:
  [[nodiscard]] double wanted_force(double integral, double error) const;
  [[nodiscard]] double limited(double force) const;

  double target_, time_constant_, closed_loop_time_;
  int interval_;
};

}  // namespace rouleau
