// SPDX-License-Identifier: BSD-3-Clause
// The tables of a report as HTML.
#pragma once

#include <string>

#include "report/report_data.hpp"

namespace rouleau::campaign {

/// A row a point and cell: axes, state, class, measures with errors, cost, link to the run directory.
[[nodiscard]] std::string point_table(const ReportData& data);

/// A row a start of the solver: when, where, how long it waited, from which step to which, how it ended.
[[nodiscard]] std::string attempt_table(const ReportData& data);

/// Core-hours, starts, crashes, rates.
[[nodiscard]] std::string cost_table(const ReportData& data);

/// Study, analysis, versions, digests.
[[nodiscard]] std::string provenance(const ReportData& data);

/// "2 done, 1 running"
[[nodiscard]] std::string state_counts(const ReportData& data);

/// "0.520 ± 0.025": as many digits as two of the error; without an error three significant ones.
[[nodiscard]] std::string with_error(const std::optional<double>& value, const std::optional<double>& error);

/// "2026-01-31 12:00 UTC"
[[nodiscard]] std::string moment_text(double unix_s);

/// "41 s", "3.2 min", "2.1 h", "4.3 d"
[[nodiscard]] std::string span_text(double seconds);

}  // namespace rouleau::campaign
