// SPDX-License-Identifier: BSD-3-Clause
// The lines before and after a figure's own script.
#include "report/figure.hpp"

#include <fmt/format.h>

#include "report/gnuplot_text.hpp"

namespace rouleau::campaign {

std::string figure_script(const Figure& figure, FigureFormat format) {
  const char* ending = format == FigureFormat::svg ? "svg" : "pdf";
  std::string text = gnuplot_comment(figure.title);
  text += fmt::format("# gnuplot {0}.gp reads {0}.dat and writes {0}.{1}\n", figure.name, ending);
  text += "reset\nset encoding utf8\n";
  // noenhanced: text of a study is shown as it is, not read as markup.
  text += format == FigureFormat::svg
              ? fmt::format("set terminal svg noenhanced size {:.0f},{:.0f} dynamic font 'sans,14' linewidth 1.2\n",
                            figure.width_px, figure.height_px)
              : fmt::format(
                    "set terminal pdfcairo noenhanced size {:.2f}cm,{:.2f}cm font 'sans,6' linewidth 0.7 "
                    "fontscale 1\n",
                    figure.width_cm, figure.height_cm);
  text += fmt::format("set output '{}.{}'\n", figure.name, ending);
  text += "set border lc rgb '#404040'\nset grid lc rgb '#d9d9d9' lw 0.6\nset tics nomirror out scale 0.6\n";
  return text + figure.script + "unset output\n";
}

}  // namespace rouleau::campaign
