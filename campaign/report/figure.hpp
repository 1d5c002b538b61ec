// SPDX-License-Identifier: BSD-3-Clause
// A figure of gnuplot's: data, script, size, and what it shows in words.
#pragma once

#include <string>

namespace rouleau::campaign {

/// `name` is letters, digits and hyphens: it becomes NAME.dat, NAME.gp, NAME.svg. The script reads 'NAME.dat' and says
/// nothing of terminals and output.
struct Figure {
  std::string name;
  std::string title;        ///< short; a heading or a caption
  std::string description;  ///< what is to be seen, for who cannot see it
  std::string data;         ///< the text of NAME.dat, with a comment that names the columns
  std::string script;
  double width_px = 500, height_px = 330;  ///< on the page
  double width_cm = 8.6, height_cm = 6;    ///< in print: one column of a journal
};

enum class FigureFormat { svg, pdf };

/// NAME.gp: complete, so that `gnuplot NAME.gp` in the directory of NAME.dat writes NAME.svg or NAME.pdf.
[[nodiscard]] std::string figure_script(const Figure& figure, FigureFormat format);

}  // namespace rouleau::campaign
