// SPDX-License-Identifier: BSD-3-Clause
// The whole step of the paper's point: both kernels, both precisions, on one rank, on two, and two jobs side by side.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "pair.hpp"
#include "paper_point.hpp"
#include "series.hpp"

namespace rouleau::speed {

struct CoupledPlan {
  std::filesystem::path study, scratch;
  Changes changes;  ///< to the point, for all variants
  int steps = 0;    ///< of a batch
  bool two_ranks = false, two_jobs = false;
};

/// One round: `coupled_ms_<variant>` and `parts.<variant>.<part>` in ms for the variants 2pt_single, 4pt_single,
/// 2pt_double, 4pt_double on rank 0; `two_rank_ms_<kernel>_single` on both; `two_jobs_steps_per_s`, the sum of two
/// simulations of variant 4pt_single, one a rank.
class CoupledCases {
 public:
  /// Collective. Both communicators must outlive it.
  CoupledCases(CoupledPlan plan, const Pair& pair, const Communicator& both, const Communicator& self);
  void measure(Series& series);
  /// Throws Error(physics) if what was measured is no flow any more. Collective.
  void check_health();

 private:
  struct Case {
    std::string name;
    PointRun run;
  };
  Case make_case(const std::string& name, const Changes& changes, const Communicator& comm) const;
  [[nodiscard]] double batch_seconds(Case& timed, Series& series) const;
  void measure_two_jobs(Series& series);

  CoupledPlan plan_;
  const Pair& pair_;
  const Communicator& both_;
  std::vector<Case> alone_;     ///< rank 0's
  std::vector<Case> together_;  ///< of both ranks
  std::optional<Case> job_;     ///< one a rank
};

}  // namespace rouleau::speed
