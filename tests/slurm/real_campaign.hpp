// SPDX-License-Identifier: BSD-3-Clause
// A campaign of the real solver on a real Slurm, and what the same study comes to without one.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/campaign_outcome.hpp"
#include "support/campaign_program.hpp"
#include "support/slurm/slurm_sandbox.hpp"

namespace rouleau::testing {

#ifdef __SANITIZE_ADDRESS__
inline constexpr const char* end_time_s = "0.01";  // steps take six times as long
#else
inline constexpr const char* end_time_s = "0.05";
#endif

/// 8 s of one core a point: 40000 steps of a coarse cell, a checkpoint at each second.
inline std::string small_study(const std::string& lambdas) {
  return "[study]\nname = small\n[sweep]\nfluid.lambda = " + lambdas +
         "\n[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
         "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
         "[cell]\nsubdivisions = 3\noffset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n"
         "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\ncorrection_interval = 50\n"
         "[time]\nend_time_s = " +
         end_time_s +
         "\n"
         "[output]\nsample_interval_steps = 40\ncheckpoint_interval_min = 0.01\nprogress_interval_s = 0.5\n"
         "[analysis]\nwindow_s = 0.002\noscillation_window_s = 0.004\n" +
         CampaignProgram::execution();
}

class RealCampaign {
 public:
  using State = rouleau::campaign::State;
  using Capture = rouleau::campaign::Capture;

  CampaignProgram program{REAL_SOLVER_PROGRAM};

  explicit RealCampaign(const std::string& lambdas, const std::string& cluster = "") {
    set_content(program.study(), small_study(lambdas));
    const Capture made = program.init();
    EXPECT_EQ(made.status, 0) << made.err;
    set_content(program.path() / "cluster.ini",
                "time_limit = 30\nranks = 1\npoll_s = 1\nclient_timeout_s = 3\nsbatch = --oversubscribe\n" + cluster);
    const Capture chosen = program.rouleau({"run", "c", "--engine", "slurm", "--cluster", "cluster.ini", "--dry-run"});
    EXPECT_EQ(chosen.status, 0) << chosen.err;
  }
  /// `rouleau run` in the background, until all is done.
  [[nodiscard]] pid_t start() const {
    return program.start({"run", "c", "--engine", "slurm", "--cluster", "cluster.ini"});
  }
  [[nodiscard]] std::filesystem::path attempt(int ordinal, int number) const {
    return program.run_directory(ordinal) / "attempts" / std::to_string(number);
  }
  [[nodiscard]] bool has_checkpoint(int ordinal) const {
    std::error_code missing;
    for (const auto& entry :
         std::filesystem::directory_iterator(program.run_directory(ordinal) / "checkpoints", missing)) {
      if (entry.path().extension() == ".h5") return true;
    }
    return false;
  }
  /// The Slurm id of an attempt's job; "" = not submitted yet.
  [[nodiscard]] std::string job_of(int ordinal, int number) const {
    std::istringstream job(content_of(attempt(ordinal, number) / "job"));
    std::string engine, id;
    job >> engine >> id;
    return id == "-" ? "" : id;
  }
  [[nodiscard]] int attempts(int ordinal) const {
    return static_cast<int>(program.store().attempts(program.point(ordinal).key).size());
  }
  [[nodiscard]] std::string report() const {
    return program.rouleau({"status", "c"}).out + program.rouleau({"why", "#1", "-C", "c"}).out;
  }
};

/// Runs the same study here, without Slurm, and expects that it came to the same, bit by bit.
inline void expect_local_outcome(const RealCampaign& campaign, const std::string& lambdas) {
  const CampaignProgram local(REAL_SOLVER_PROGRAM);
  set_content(local.study(), small_study(lambdas));
  ASSERT_EQ(local.init().status, 0);
  ASSERT_EQ(local.run().status, 0);
  const CampaignOutcome expected = outcome_of(local), found = outcome_of(campaign.program);
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.parameters, expected.parameters);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.results, expected.results);
  for (std::size_t i = 0; i < expected.logs.size(); ++i) {
    EXPECT_TRUE(found.logs.at(i) == expected.logs[i]) << "samples.csv of point " << i + 1 << " differs";
  }
  const auto verified = campaign.program.rouleau({"verify", "c"});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

}  // namespace rouleau::testing
