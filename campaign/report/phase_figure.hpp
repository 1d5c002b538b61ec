// SPDX-License-Identifier: BSD-3-Clause
// The phase diagram: displacement against an axis, and a map of the classes over two.
#pragma once

#include <optional>

#include "report/figure.hpp"
#include "report/report_data.hpp"

namespace rouleau::campaign {

/// Mean displacement with error bars against λ (or the first axis that is a number, or the number of the point); class
/// by colour and shape, open while a point is not done; a second axis by thin lines through its values.
/// Nothing without any mean displacement.
[[nodiscard]] std::optional<Figure> phase_figure(const ReportData& data);

/// Classes over the first two axes, and the boundary between the last croissant and the first slipper of each row.
/// Nothing unless two axes are numbers, with at least two values each, and some class is known.
[[nodiscard]] std::optional<Figure> map_figure(const ReportData& data);

}  // namespace rouleau::campaign
