// SPDX-License-Identifier: BSD-3-Clause
// The tables of [execution] and [analysis].
#include "study/settings.hpp"

#include <fmt/format.h>

#include "study/numbers.hpp"

namespace rouleau::campaign {

namespace {

constexpr SettingRow<Execution> execution_table[] = {
    {"jobs", &Execution::jobs, 0, 1024, true, "jobs at a time; 0 = as many as the cores allow"},
    {"ranks", &Execution::ranks, 1, 4096, true, "MPI ranks of a job"},
    {"retries", &Execution::retries, 0, 1000, true, "crashes in a row without progress, then the point is given up"},
    {"niceness", &Execution::niceness, 0, 19, true, "niceness of the jobs"},
    {"oversubscribe", &Execution::oversubscribe, 0, 1, true, "1 = more ranks than cores are allowed"},
    {"retry_delay_s", &Execution::retry_delay_s, 0, 86400, false, "pause before a retry without progress; doubles"},
    {"io_retry_delay_s", &Execution::io_retry_delay_s, 0, 86400, false, "pause after a file error; grows fourfold"},
    {"pause_after_failures", &Execution::pause_after_failures, 0, 1000, true,
     "so many points failing early and alike pause the campaign; 0 = never"},
};

constexpr SettingRow<Analysis> analysis_table[] = {
    {"window_s", &Analysis::window_s, 1e-9, 1e6, false, "averages are taken over the last window_s of the run"},
    {"oscillation_window_s", &Analysis::oscillation_window_s, 1e-9, 1e6, false,
     "amplitude and period of d are sought in the last oscillation_window_s"},
    {"croissant_d_um", &Analysis::croissant_d_um, 0, 1000, false, "mean displacement at most this: croissant"},
    {"slipper_d_um", &Analysis::slipper_d_um, 0, 1000, false, "mean displacement at least this: slipper"},
    {"drift_um", &Analysis::drift_um, 0, 1000, false,
     "change from the window before, towards the other class, above this: undecided"},
};

}  // namespace

namespace {

template <class Settings>
std::string help_of(std::span<const SettingRow<Settings>> rows) {
  const Settings defaults;
  std::string text;
  for (const SettingRow<Settings>& row : rows) {
    text += fmt::format("    {:<22} = {:<5} # {} [{} ... {}]\n", row.name, shortest(defaults.*row.member), row.help,
                        shortest(row.minimum), shortest(row.maximum));
  }
  return text;
}

constexpr std::string_view study_and_sweep =
    "A study file is INI text: [section], name = value, # comments. It has the sections of the run file\n"
    "(`rouleau-solver --help-run-file` lists them), whose entries hold for every point, and these:\n\n"
    "[study]\n"
    "    name = lambda-sweep          # letters, digits, _ - .\n\n"
    "[sweep]\n"
    "    fluid.lambda = 1, 2, 4:5:0.25  # an axis: section.name = values and from:to:step ranges\n"
    "    mode = product               # of several axes; or zip: side by side\n"
    "    replicas = 3                 # each point so often, with cell.replica = 1, 2, 3; needs cell.jitter_um above "
    "0\n\n";

}  // namespace

std::string study_help() {
  return std::string(study_and_sweep) +
         "[execution]\n"
         "    engine                 = local # where jobs run: local (this machine) or slurm (see cluster.ini)\n"
         "    checkpoint_interval_min        # another way to write output.checkpoint_interval_min\n" +
         help_of(execution_rows()) + "\n[analysis]\n" + help_of(analysis_rows());
}

std::span<const SettingRow<Execution>> execution_rows() { return execution_table; }
std::span<const SettingRow<Analysis>> analysis_rows() { return analysis_table; }

}  // namespace rouleau::campaign
