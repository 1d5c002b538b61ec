// SPDX-License-Identifier: BSD-3-Clause
// The report as one HTML page that needs nothing else: no network, no script.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/cell_shape.hpp"
#include "report/figure.hpp"
#include "report/report_data.hpp"

namespace rouleau::campaign {

/// A figure and its <svg> element; without one it could not be drawn.
struct DrawnFigure {
  Figure figure;
  std::optional<std::string> svg;
};

/// What the page shows besides the data.
struct PageParts {
  std::optional<DrawnFigure> phase, map, overlay, timeline;
  std::map<int, DrawnFigure> series;         ///< by the point's ordinal
  std::map<int, std::vector<Shape>> shapes;  ///< by ordinal, oldest first
  std::map<int, Shape> slices;               ///< by ordinal; with flags
  std::vector<std::string> notes;            ///< what is missing, why, and what to do about it
  std::optional<int> refresh_s;              ///< a browser that has it open reads it again after so many seconds
};

/// Points up to which everything of each is spread out; more are folded into <details>.
inline constexpr std::size_t most_spread_points = 12;

/// The whole page. Every text that does not come from this program is escaped.
[[nodiscard]] std::string report_page(const ReportData& data, const PageParts& parts);

}  // namespace rouleau::campaign
