// SPDX-License-Identifier: BSD-3-Clause
// The tables of [execution] and [analysis].
#include "study/settings.hpp"

namespace rouleau::campaign {

namespace {

constexpr SettingRow<Execution> execution_table[] = {
    {"jobs", &Execution::jobs, 0, 1024, true, "jobs at a time; 0 = as many as the cores allow"},
    {"ranks", &Execution::ranks, 1, 4096, true, "MPI ranks of a job"},
    {"retries", &Execution::retries, 0, 1000, true, "restarts in a row without progress, then the point is given up"},
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

std::span<const SettingRow<Execution>> execution_rows() { return execution_table; }
std::span<const SettingRow<Analysis>> analysis_rows() { return analysis_table; }

}  // namespace rouleau::campaign
