// SPDX-License-Identifier: BSD-3-Clause
// What `rouleau status --watch` knows at one moment: the points, what they cost, what happened last.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "commands/point_status.hpp"

namespace rouleau::campaign {

/// A change of a point's state.
struct Change {
  std::int64_t id = 0;
  double unix_s = 0;
  int ordinal = 0;
  std::string from, to, evidence;
};

/// Which changes are asked for: the newest ones after `after_id`, at most so many; -1 = all.
struct ChangesWanted {
  std::int64_t after_id = 0;
  int most = 5;
};

struct WatchFacts {
  std::string name;
  double now_unix_s = 0;
  std::vector<std::string> axes;  ///< full names of the swept parameters
  std::vector<PointStatus> points;
  std::map<std::string, std::string> classes;  ///< by key, as far as there are samples
  std::vector<Change> changes;                 ///< newest first
  /// Core-seconds and steps of the attempts that ended with a record; those that were killed left none.
  double ended_core_s = 0;
  std::int64_t ended_steps = 0;
  std::string warning;  ///< why nothing is started any more, or why this is not the newest state; "" = all is well

  /// Whether every point of the study is through.
  [[nodiscard]] bool is_over() const;
  /// Of all steps of the study, from 0 to 1.
  [[nodiscard]] double fraction() const;
  /// Core-hours spent, by those that run too.
  [[nodiscard]] double core_h_used() const;
  /// Core-hours that the steps left will take at the mean cost of those done; nothing while no cost is known.
  [[nodiscard]] std::optional<double> core_h_left() const;
};

/// Reads the facts anew each time. Between two reads the database is closed.
class WatchReader {
 public:
  explicit WatchReader(std::filesystem::path campaign) : campaign_(campaign), points_(std::move(campaign)) {}
  [[nodiscard]] WatchFacts read(const ChangesWanted& wanted);

 private:
  std::filesystem::path campaign_;
  StatusReader points_;
  std::string study_digest_;  ///< of the study that axes_ belong to
  std::vector<std::string> axes_;
};

}  // namespace rouleau::campaign
