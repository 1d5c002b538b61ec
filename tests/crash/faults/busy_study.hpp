// SPDX-License-Identifier: BSD-3-Clause
// A study of two runs of the real solver that touch their files as often as they can.
#pragma once

#include <fmt/format.h>

#include <string>

#include "support/campaign_program.hpp"

namespace rouleau::testing {

/// With so many steps a run; a checkpoint at every look at the clock, a sample every tenth step.
inline std::string busy_study(int steps) {
  constexpr double time_step_s = 1.25e-6;
  return fmt::format(
             "[study]\nname = busy\n[sweep]\nfluid.lambda = 1, 8\n"
             "[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
             "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
             "[cell]\nsubdivisions = 4\noffset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n"
             "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\ncorrection_interval = 7\n"
             "[bounds]\nunsafe_combination = run\n[time]\nend_time_s = {:.9f}\n"
             "[output]\nsample_interval_steps = 10\ncheckpoint_interval_min = 0.0001\nprogress_interval_s = 0.1\n"
             "[analysis]\nwindow_s = 0.00002\noscillation_window_s = 0.00004\n",
             steps * time_step_s) +
         CampaignProgram::execution();
}

}  // namespace rouleau::testing
