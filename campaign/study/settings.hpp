// SPDX-License-Identifier: BSD-3-Clause
// The study file's own settings, [execution] and [analysis]: names, defaults, ranges, meaning.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rouleau::campaign {

/// How the points are run; section [execution].
struct Execution {
  std::string engine = "local";     ///< where jobs run: "local" is this machine, "slurm" a cluster
  double jobs = 0;                  ///< at a time; 0 = as many as the cores allow
  double ranks = 1;                 ///< MPI ranks of a job
  double retries = 3;               ///< restarts in a row without progress after crashes; then the point is given up
  double niceness = 0;              ///< 0 ... 19, of the jobs
  double oversubscribe = 0;         ///< 1: more ranks than cores are allowed
  double retry_delay_s = 10;        ///< pause before a retry without progress; doubles each time
  double io_retry_delay_s = 60;     ///< the same after a file error (disk full); grows fourfold each time
  double pause_after_failures = 3;  ///< so many points failing early and alike pause the campaign; 0 = never
};

/// How the series are judged; section [analysis]. The rule that uses these numbers is stated in report/analysis.hpp.
struct Analysis {
  double window_s = 0.2;              ///< averages are taken over the last window_s of the run
  double oscillation_window_s = 1.0;  ///< amplitude and period of d are sought in the last oscillation_window_s
  double croissant_d_um = 0.3;        ///< mean displacement at most this: croissant
  double slipper_d_um = 0.5;          ///< mean displacement at least this: slipper
  double drift_um = 0.1;              ///< change from the window before, towards the other class: more is undecided
};

/// One number of a settings struct. Both sections are read, checked and documented from such tables.
template <class Settings>
struct SettingRow {
  std::string_view name;
  double Settings::*member;
  double minimum;
  double maximum;
  bool whole;  ///< whole numbers only
  std::string_view help;
};

[[nodiscard]] std::span<const SettingRow<Execution>> execution_rows();
[[nodiscard]] std::span<const SettingRow<Analysis>> analysis_rows();

/// How a study file is written, for people: all sections, and these settings with default, range and meaning.
[[nodiscard]] std::string study_help();

}  // namespace rouleau::campaign
