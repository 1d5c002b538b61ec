// SPDX-License-Identifier: BSD-3-Clause
// One point of a study: its parameters, its key, and the point.json that lies beside its run file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// One effective run parameter, as the solver's `check` names it.
struct Parameter {
  std::string name;         ///< "fluid.lambda"
  std::string value;        ///< canonical text: 4.75 and 4.750 are both "4.75"
  bool is_identity = true;  ///< defines the point; false: free (end time, intervals, output)
  bool is_given = false;    ///< the study file names it; false: the solver's default

  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// What the solver says a run will be; all of one point.
struct RunFacts {
  std::int64_t steps = 0;
  double time_step_us = 0;
  double end_time_s = 0;
  std::int64_t nodes = 0;
  std::int64_t samples = 0;
  std::int64_t checkpoint_bytes = 0;
  std::int64_t snapshot_bytes = 0;
  double relative_cost_per_step = 0;  ///< comparable between points, of no unit

  friend bool operator==(const RunFacts&, const RunFacts&) = default;
};

/// One point, complete enough to run it and to rebuild the database from its directory.
struct Point {
  std::string key;       ///< the first 12 hex digits of `identity` (more if two points share those)
  std::string identity;  ///< 32 hex digits from the solver: digest of the identity parameters
  int ordinal = 0;       ///< 1, 2, 3 ... in the order in which points joined the campaign; never reused
  int replica = 0;       ///< cell.replica; 0 = none
  bool in_study = true;  ///< still named by the study file
  bool cancelled = false;
  int retried_after = 0;              ///< the newest attempt when the user last asked for a retry; 0 = never
  std::string run_file_digest;        ///< of run.ini as written by `init`; empty: written before this was kept
  std::vector<std::string> swept;     ///< names of the axes, in the study file's order
  std::vector<Parameter> parameters;  ///< all effective run parameters
  RunFacts facts;

  /// The value of a parameter, or nullptr.
  [[nodiscard]] const std::string* find(const std::string& name) const;
  /// "fluid.lambda = 5, cell.replica = 2": the swept parameters, or the key when nothing is swept.
  [[nodiscard]] std::string label() const;

  friend bool operator==(const Point&, const Point&) = default;
};

/// Reads points/<key>/point.json.   throws Error (damaged) naming the file
[[nodiscard]] Point read_point(const std::filesystem::path& file);

/// Whether it is nothing but lower-case hex digits: what keys and identities, and so directories' names, are made of.
[[nodiscard]] bool is_hex(const std::string& text);

/// Writes points/<key>/point.json: aside, synced, renamed.
void write_point(const std::filesystem::path& file, const Point& point);

/// points/<key> of a campaign.
[[nodiscard]] std::filesystem::path point_directory(const std::filesystem::path& campaign, const std::string& key);

}  // namespace rouleau::campaign
