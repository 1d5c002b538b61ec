// SPDX-License-Identifier: BSD-3-Clause
// A run as the solver runs it: what samples, progress and health checks cost around the step, and the parts of the step
// that do not come in each.
#pragma once

#include "paper_point.hpp"
#include "series.hpp"

namespace rouleau::speed {

/// One round, shares of a run's wall clock in the variant 4pt_single: `tracking_share`, `volume_share`,
/// `correction_share` of the step's own timers, `sampling_share` of all that the loop does between steps. One round, in
/// ms and MB: `checkpoint_write_ms`, `checkpoint_verify_ms`, `checkpoint_read_ms`, `checkpoint_mb`.
class LoopCase {
 public:
  /// `run` must outlive it and is stepped on; on one rank. `directory`: of the run's files.
  LoopCase(PointRun& run, std::filesystem::path directory) : run_(run), directory_(std::move(directory)) {}

  /// Runs over two sample intervals.
  void measure_shares(Series& series);
  void measure_checkpoint(Series& series);

 private:
  PointRun& run_;
  std::filesystem::path directory_;
};

}  // namespace rouleau::speed
