// SPDX-License-Identifier: BSD-3-Clause
// Proportional-integral control of the mean velocity.
#include "fluid/controller.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace rouleau {

namespace {

// Half the channel's own time, but never so fast that the force held between two updates matters to the damping.
double closed_loop_time(double time_constant, int interval) { return std::max(time_constant / 2, 10.0 * interval); }

// Multiple of the empty channel's force: room for cells that plug the channel, not for a force that would tear it.
constexpr double force_reserve = 10;

}  // namespace

MeanVelocityController::MeanVelocityController(double target, double time_constant, int interval)
    : target_(target),
      time_constant_(time_constant),
      closed_loop_time_(closed_loop_time(time_constant, interval)),
      interval_(interval) {
  if (!std::isfinite(target) || target == 0)
    fail(Exit::bad_input, "mean velocity to hold is {}; it must be finite and not zero. Choose driving = rest instead.",
         target);
  if (!(time_constant > 0) || interval < 1)
    fail(Exit::bad_input, "controller has time constant {} and interval {} steps; both must be positive.",
         time_constant, interval);
}

double MeanVelocityController::largest_force() const { return force_reserve * std::abs(target_) / time_constant_; }

double MeanVelocityController::wanted_force(double integral, double error) const {
  return integral + (2 / closed_loop_time_ - 1 / time_constant_) * error;
}

double MeanVelocityController::limited(double force) const {
  return std::clamp(force, -largest_force(), largest_force());
}

ControllerState MeanVelocityController::start(double mean_velocity) const {
  const double error = target_ - mean_velocity;
  const double integral = target_ / time_constant_ - error / closed_loop_time_;
  return {integral, limited(wanted_force(integral, error))};
}

void MeanVelocityController::update(ControllerState& state, double mean_velocity) const {
  const double error = target_ - mean_velocity, wanted = wanted_force(state.integral, error);
  state.force = limited(wanted);
  const bool winds_up = state.force != wanted && (wanted > 0) == (error > 0);
  if (!winds_up) state.integral += interval_ * error / (closed_loop_time_ * closed_loop_time_);
}

}  // namespace rouleau
