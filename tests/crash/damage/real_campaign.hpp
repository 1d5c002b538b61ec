// SPDX-License-Identifier: BSD-3-Clause
// A campaign of three short real runs.
#pragma once

#include "support/campaign_outcome.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::testing {

/// λ = 1, 5, 8 of a coarse cell, 40 steps each.
inline std::string real_study() {
  return "[study]\nname = real\n[sweep]\nfluid.lambda = 1, 5, 8\n"
         "[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
         "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
         "[cell]\nsubdivisions = 3\noffset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n"
         "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\n"
         "[time]\nend_time_s = 0.00005\n[output]\nsample_interval_steps = 10\n"
         "[analysis]\nwindow_s = 0.00002\noscillation_window_s = 0.00004\n" +
         CampaignProgram::execution();
}

/// Made, not run yet.
class RealCampaign : public CampaignProgram {
 public:
  RealCampaign() : CampaignProgram(REAL_SOLVER_PROGRAM) {
    set_content(study(), real_study());
    const Capture made = init();
    EXPECT_EQ(made.status, 0) << made.err;
  }
  void finish() const {
    const Capture finished = run();
    EXPECT_EQ(finished.status, 0) << finished.err;
  }
};

}  // namespace rouleau::testing
