// SPDX-License-Identifier: BSD-3-Clause
// Having figures drawn by gnuplot.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "report/figure.hpp"

namespace rouleau::campaign {

/// The program of that name on the PATH, or nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_on_path(const std::string& program);

/// Writes NAME.dat and NAME.gp of each figure into the directory and has them drawn there as NAME.svg or NAME.pdf, all
/// by one gnuplot; what that leaves out is tried again one by one. gnuplot reads no settings of the user's.
/// returns  empty, or why some are missing, with the next step
[[nodiscard]] std::string draw_figures(std::span<const Figure> figures, const std::filesystem::path& directory,
                                       FigureFormat format);

}  // namespace rouleau::campaign
