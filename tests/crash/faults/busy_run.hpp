// SPDX-License-Identifier: BSD-3-Clause
// A short run of the real solver that touches its files as often as it can.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "restart/small_run.hpp"
#include "support/fault_shim/call_log.hpp"
#include "support/fault_shim/faults.hpp"

namespace rouleau::testing {

class BusyRun : public SmallRun {
 public:
  /// Checkpoint and progress at every look at the clock (a fine mesh makes steps slow enough for that), five samples,
  /// three snapshots of fields and cells.
  BusyRun()
      : SmallRun({{"cell.subdivisions", "4"},
                  {"output.checkpoint_interval_min", "0.0001"},
                  {"output.progress_interval_s", "0.1"},
                  {"output.snapshot_interval_s", "3e-5"}}) {
    set_steps(48);
  }
  [[nodiscard]] std::filesystem::path directory() const { return path("run.ini").parent_path(); }
  /// Of the run and of its snapshots.
  [[nodiscard]] std::string fingerprint() const {
    std::string all = SmallRun::fingerprint();
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path("snapshots"))) files.insert(entry.path());
    for (const auto& file : files)
      all += fmt::format("{} {:016x}\n", file.filename().string(), std::hash<std::string>()(content_of(file)));
    return all;
  }
};

inline constexpr const char* solver_program = "rouleau-solver";

/// Runs it undisturbed.   returns its calls
inline std::vector<RecordedCall> recorded(const BusyRun& run, int ranks, Watch watch = Watch::changes) {
  Faults faults(run.directory(), solver_program, {.watch = watch});
  faults.record();
  const Finished finished = run.run(ranks);
  EXPECT_EQ(finished.code, 0) << finished.err;
  return read_calls(faults.log());
}

}  // namespace rouleau::testing
