// SPDX-License-Identifier: BSD-3-Clause
// Every start of the solver as a bar over the wall clock: crashes, resumes and waiting are to be seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figure.hpp"
#include "report/report_data.hpp"

namespace rouleau::campaign {

/// How an attempt ended, or that it has not.
enum class End { finished, stopped, crashed, failed, running, superseded };

[[nodiscard]] End end_of(const AttemptRow& attempt);
[[nodiscard]] std::string_view word_of(End end);

/// The parts of an attempt's bar, in seconds since 1970.
struct Bar {
  double submitted = 0, begun = 0, ended = 0;  ///< equal where a part is missing
  End end = End::running;
};

/// An attempt without a recorded end lasts until `now`, or for as long as it computed.
[[nodiscard]] Bar bar_of(const ReportPoint& point, const AttemptRow& attempt, double now);

/// A row a point, a bar an attempt, a sign at its end for how it ended. Nothing before the first attempt.
[[nodiscard]] std::optional<Figure> timeline_figure(const ReportData& data);

}  // namespace rouleau::campaign
