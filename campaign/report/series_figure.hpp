// SPDX-License-Identifier: BSD-3-Clause
// d(t) and asphericity(t), of one point and of all together.
#pragma once

#include <optional>

#include "report/figure.hpp"
#include "report/report_data.hpp"

namespace rouleau::campaign {

/// Points up to which the overlay shows each curve in a colour and dash of its own.
inline constexpr std::size_t most_single_curves = 12;

/// Both measures of all cells of a point over time, one above the other; the window of the averages is shaded. Nothing
/// without samples.
[[nodiscard]] std::optional<Figure> series_figure(const ReportData& data, const ReportPoint& point);

/// All points together. Up to most_single_curves each has a colour and a dash; more are coloured by the first axis that
/// is a number, in two panels a class. A curve has as many points as fit: most_points in all. Nothing unless two
/// points have samples.
[[nodiscard]] std::optional<Figure> overlay_figure(const ReportData& data, std::size_t most_points);

}  // namespace rouleau::campaign
