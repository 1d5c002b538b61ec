// SPDX-License-Identifier: BSD-3-Clause
// A campaign of the real solver, some seconds long, to be reported on.
#pragma once

#include <string>

#include "support/campaign_program.hpp"

namespace rouleau::testing {

/// Two coarse cells, at λ = 1 and 5; a comment of the study file tries to become markup.
inline std::string small_study(const std::string& end_time_s) {
  return "# <script>alert('x')</script> & \"quoted\" `touch pwned`\n[study]\nname = small\n[sweep]\nfluid.lambda = 1, "
         "5\n"
         "[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
         "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
         "[cell]\nsubdivisions = 3\noffset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n"
         "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\ncorrection_interval = 50\n"
         "[time]\nend_time_s = " +
         end_time_s +
         "\n[output]\nsample_interval_steps = 20\ncheckpoint_interval_min = 0.005\nprogress_interval_s = 0.2\n"
         "[analysis]\nwindow_s = 0.002\noscillation_window_s = 0.004\n" +
         CampaignProgram::execution();
}

}  // namespace rouleau::testing
