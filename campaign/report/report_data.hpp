// SPDX-License-Identifier: BSD-3-Clause
// All that a report says, read once: figures, tables and page are pure functions of this.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/store.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

/// The series of one cell, thinned.
struct Curve {
  int cell = 0;
  std::vector<double> time_s, d_um, asphericity;  ///< of equal length; not finite = NaN
};

/// A point with everything that is drawn or listed of it.
struct ReportPoint {
  PointRow row;
  std::vector<ParameterRow> swept;
  std::optional<double> lambda;
  std::vector<ResultRow> results;  ///< one a cell; none before the first sample
  std::vector<AttemptRow> attempts;
  std::vector<Curve> curves;  ///< one a cell

  // From the run directory, by who may read it; unset where a file is not there.
  std::map<int, double> began_unix_s;  ///< when an attempt that waited for a scheduler began to compute
  std::optional<std::int64_t> step;    ///< newest, of progress.json
  std::string link;                    ///< to the run directory, relative to the report
  std::string identity, run_file_digest;

  /// "λ = 5, replica = 2": the swept parameters, or the key when nothing is swept.
  [[nodiscard]] std::string label() const;
  /// Of all its steps, from 0 to 1.
  [[nodiscard]] double fraction() const;
  /// What is known of the class: that of the first cell, or nothing.
  [[nodiscard]] const ResultRow* result() const { return results.empty() ? nullptr : &results.front(); }
};

struct ReportData {
  CampaignRow campaign;
  Analysis analysis;               ///< as stored
  std::vector<std::string> swept;  ///< full names of the axes, in the run file's order
  std::vector<ReportPoint> points;
  double written_unix_s = 0;
  std::string version, git;  ///< of the rouleau that writes the report

  /// The value of an axis of a point, if it is a number.
  [[nodiscard]] static std::optional<double> value(const ReportPoint& point, const std::string& axis);
  /// Axes whose values are numbers for every point, λ first; never the replica.
  [[nodiscard]] std::vector<std::string> numeric_axes() const;
  [[nodiscard]] bool is_finished() const;  ///< every point of the study is in a final state
};

/// Reads what the database knows; a curve is thinned to `most` points as soon as it is read.
/// The points come by the values of the axes, λ first.
[[nodiscard]] ReportData read_report(const Store& store, std::size_t most);

}  // namespace rouleau::campaign
