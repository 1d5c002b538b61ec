// SPDX-License-Identifier: BSD-3-Clause
// Which snapshots a run takes, when, and how each follows from the state.
#pragma once

#include <filesystem>

#include "run/simulation.hpp"
#include "run/step_schedule.hpp"
#include "storage/attempt.hpp"
#include "storage/snapshot_series.hpp"

namespace rouleau {

/// When a run takes snapshots: at each due step the cells, at some of them the fields too.
struct SnapshotPlan {
  StepSchedule fields, cells;
  bool has_cells;

  explicit SnapshotPlan(const Setup& setup);
  [[nodiscard]] bool fields_are_due(std::int64_t step) const { return fields.is_due(step); }
  [[nodiscard]] bool cells_are_due(std::int64_t step) const {
    return has_cells && (fields.is_due(step) || cells.is_due(step));
  }
  /// In the steps 0 ... `last`.
  [[nodiscard]] std::int64_t field_count(std::int64_t last) const { return fields.count(last); }
  [[nodiscard]] std::int64_t cell_count(std::int64_t last) const;
};

/// What all snapshots and series of this run will take at its end: arrays compressed as measured (share/contract.md
/// section 13), an estimate from above for a cell in a flow.
std::int64_t snapshot_bytes(const Setup& setup);

/// Takes a run's snapshots. All that it is made of must outlive it.
class Snapshots {
 public:
  /// `attempt` is rank 0's, null elsewhere.
  Snapshots(const Setup& setup, const Communicator& comm, FileSystem& files, const std::filesystem::path& run_directory,
            const Attempt* attempt);

  /// Between two steps: writes what is due, over what an earlier attempt may have written of the same step, and brings
  /// the series up to date. Collective.
  /// throws Error(physics) if the state is not sound, Error(superseded), Error(io)
  void take(Simulation& simulation);

 private:
  [[nodiscard]] SnapshotPlace place() const;
  [[nodiscard]] SnapshotMoment moment(std::int64_t step) const;
  [[nodiscard]] FieldSnapshot field_snapshot(const LatticePicture& picture, std::int64_t step) const;
  [[nodiscard]] CellSnapshot cell_snapshot(const Cells& cells, std::int64_t step) const;

  const Setup& setup_;
  const Communicator& comm_;
  FileSystem& files_;
  std::filesystem::path directory_;
  const Attempt* attempt_;
  SnapshotPlan plan_;
  SnapshotSeries field_series_{SnapshotKind::fields}, cell_series_{SnapshotKind::cells};
};

}  // namespace rouleau
