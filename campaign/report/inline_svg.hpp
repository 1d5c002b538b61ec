// SPDX-License-Identifier: BSD-3-Clause
// An SVG file of gnuplot's as an element of a page among others of its kind.
#pragma once

#include <optional>
#include <string>

#include "report/figure.hpp"

namespace rouleau::campaign {

/// The <svg> element of gnuplot's file: with the figure's title and description in place of gnuplot's own, ids that no
/// other figure of the page has, no names of namespaces, no definitions that are not used, shorter white space.
/// Nothing if `file_text` does not hold a whole picture.
[[nodiscard]] std::optional<std::string> inline_svg(const Figure& figure, std::string file_text);

/// The beginning of an <svg> element that a screen reader can name; `id` is unique in the page.
[[nodiscard]] std::string svg_head(const std::string& id, const std::string& view_box, const std::string& title,
                                   const std::string& description);

}  // namespace rouleau::campaign
