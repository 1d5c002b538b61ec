// SPDX-License-Identifier: BSD-3-Clause
// A short run of the real solver that touches its files as often as it can.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "restart/small_run.hpp"
#include "support/fault_shim/call_log.hpp"
#include "support/fault_shim/faults.hpp"

namespace rouleau::testing {

class BusyRun : public SmallRun {
 public:
  /// Checkpoint and progress at every look at the clock (a fine mesh makes steps slow enough for that), five samples.
  BusyRun()
      : SmallRun({{"cell.subdivisions", "4"},
                  {"output.checkpoint_interval_min", "0.0001"},
                  {"output.progress_interval_s", "0.1"}}) {
    set_steps(48);
  }
  [[nodiscard]] std::filesystem::path directory() const { return path("run.ini").parent_path(); }
};

inline constexpr const char* solver_program = "rouleau-solver";

/// Runs it undisturbed.   returns its calls
inline std::vector<RecordedCall> recorded(const BusyRun& run, int ranks) {
  Faults faults(run.directory(), solver_program, {});
  faults.record();
  const Finished finished = run.run(ranks);
  EXPECT_EQ(finished.code, 0) << finished.err;
  return read_calls(faults.log());
}

}  // namespace rouleau::testing
