// SPDX-License-Identifier: BSD-3-Clause
// All that a report shows of a campaign, gathered from its database and its run directories; reads only.
#pragma once

#include <filesystem>
#include <vector>

#include "commands/report_shapes.hpp"
#include "report/report_data.hpp"
#include "report/report_page.hpp"

namespace rouleau::campaign {

/// The data of the report; links are relative to the report's directory.
[[nodiscard]] ReportData report_data(const std::filesystem::path& campaign, const std::filesystem::path& report);

/// Every figure that the data give, the series of single points last.
[[nodiscard]] std::vector<Figure> report_figures(const ReportData& data);

/// Shapes and slices of as many points and times as a page of some megabytes holds.
void add_shapes(PageParts& parts, const ReportData& data, const std::filesystem::path& campaign, ShapeReader& reader);

}  // namespace rouleau::campaign
