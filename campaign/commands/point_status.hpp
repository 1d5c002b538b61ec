// SPDX-License-Identifier: BSD-3-Clause
// How far each point is: what the database knows of it and what its run directory says at this moment.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ingest/run_files.hpp"
#include "store/store.hpp"

namespace rouleau::campaign {

/// One point at this moment.
struct PointStatus {
  PointRow point;
  std::vector<Value> swept;  ///< one an axis; NULL where the point has no such parameter
  std::optional<ProgressFile> progress;
  std::int64_t step = 0;
  int attempts = 0;
  bool lives = false;
  bool is_queued = false;          ///< handed to Slurm, which has not started it yet
  bool is_behind = false;          ///< its directory proves another state than the recorded one
  std::int64_t steps_of_life = 0;  ///< done by the attempt that lives
  int ranks = 1;                   ///< of the newest attempt
  std::string note;                ///< what Slurm, the end of the attempt or a damaged file says

  /// Of all its steps, from 0 to 1.
  [[nodiscard]] double fraction() const;
  /// Steps a second, if it lives and says so; else 0.
  [[nodiscard]] double speed() const;
  /// For people: a point that waits in Slurm's queue does not run.
  [[nodiscard]] std::string state_word() const;
  /// Steps that the study still wants of it.
  [[nodiscard]] std::int64_t steps_left() const;
};

/// Reads the points again and again; the files of one that is through are read once.
class StatusReader {
 public:
  explicit StatusReader(std::filesystem::path campaign) : campaign_(std::move(campaign)) {}

  /// All points by ordinal; `axes` are the full names of the parameters that `swept` holds.
  [[nodiscard]] std::vector<PointStatus> read(const Store& store, const std::vector<std::string>& axes);

 private:
  struct Settled {
    PointRow point;
    AttemptRow newest;
    PointStatus status;
  };
  [[nodiscard]] PointStatus status_of(const PointRow& point, const AttemptRow* newest);

  std::filesystem::path campaign_;
  std::map<std::string, Settled> settled_;
};

/// "3 done, 2 running, 1 queued": how many points are in each state.
[[nodiscard]] std::string states_text(const std::vector<PointStatus>& points);

/// What those that run promise for all that is left.
struct Outlook {
  int living = 0;
  double left_s = 0;  ///< until all is done; of no meaning while nothing lives
};
[[nodiscard]] Outlook outlook_of(const std::vector<PointStatus>& points);

/// Whether the point needs its user: it failed, was refused, or crashed.
[[nodiscard]] bool is_in_trouble(const PointStatus& status);

/// Whether one ended for good without being done, which `--exit-code` tells by 4.
[[nodiscard]] bool has_failures(const std::vector<PointStatus>& points);

}  // namespace rouleau::campaign
