// SPDX-License-Identifier: BSD-3-Clause
// Blocks of time, d and asphericity; two panels over one time axis.
#include "report/series_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/gnuplot_text.hpp"
#include "report/palette.hpp"
#include "report/parameter_words.hpp"
#include "report/thin.hpp"

namespace rouleau::campaign {
namespace {

constexpr std::string_view columns = "time_s, d_um, asphericity";

std::string block_of(const Curve& curve, std::size_t most, const std::string& name) {
  std::string text = gnuplot_comment(name);
  for (const std::size_t i : thinned(curve.d_um, most))
    text += fmt::format("{} {} {}\n", gnuplot_number(curve.time_s[i]), gnuplot_number(curve.d_um[i]),
                        gnuplot_number(curve.asphericity[i]));
  return text + "\n\n";
}

bool has_numbers(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool is_drawn(const Curve& curve) { return has_numbers(curve.d_um) && has_numbers(curve.asphericity); }

/// Two panels, `plots(column)` in each.
template <class Plots>
std::string two_panels(const Plots& plots) {
  std::string script = "set multiplot layout 2,1 spacing 0.0,0.06\nset lmargin 9\nset yrange [0:*]\n";
  script += "set format x ''\nset ylabel 'd, µm'\nset bmargin 0.6\nset tmargin 0.6\nplot " + plots(2) + "\n";
  script += "set format x '%g'\nset xlabel 't, s'\nset ylabel 'asphericity'\nset bmargin 3.2\nunset object\nplot ";
  return script + plots(3) + "\nunset multiplot\n";
}

std::string ordinary_words(const ReportPoint& point) {
  return fmt::format("#{}: {}", point.row.ordinal, point.label());
}

std::string ends(const ReportPoint& point) {
  std::string text;
  for (const ResultRow& cell : point.results) {
    if (!cell.d_mean_um) continue;
    text += fmt::format(" Cell {} ends as {}, d {:.3g} µm on average.", cell.cell, cell.phase, *cell.d_mean_um);
  }
  return text;
}

/// The curve of the first cell of every point that has one.
std::vector<std::pair<const ReportPoint*, const Curve*>> first_curves(const ReportData& data) {
  std::vector<std::pair<const ReportPoint*, const Curve*>> curves;
  for (const ReportPoint& point : data.points)
    if (!point.curves.empty() && is_drawn(point.curves.front())) curves.emplace_back(&point, &point.curves.front());
  return curves;
}

std::string look_of(std::size_t i) {
  constexpr std::array<int, 3> dashes = {1, 2, 4};
  return fmt::format("lw 1.3 lc rgb '{}' dt {}", curve_colours[i % curve_colours.size()],
                     dashes[i / curve_colours.size() % dashes.size()]);
}

/// A panel a class, coloured by an axis.
std::string grouped_script(const std::vector<std::pair<const ReportPoint*, const Curve*>>& curves,
                           const std::string& axis, int& panels) {
  std::string script = fmt::format(
      "set palette cividis\nset cblabel {}\nset yrange [0:*]\nset ylabel 'd, µm'\nset lmargin 9\nset rmargin 14\n",
      gnuplot_quoted(axis.empty() ? "point" : axis_title(axis)));
  std::string plots;
  panels = 0;
  for (const ClassLook& look : class_looks) {
    std::string plot;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const ReportPoint& point = *curves[i].first;
      const bool belongs = point.result() != nullptr ? point.result()->phase == look.name : look.name == "undecided";
      if (!belongs) continue;
      const double value = axis.empty() ? point.row.ordinal : *ReportData::value(point, axis);
      plot += fmt::format("{}'overlay.dat' index {} using 1:2:({:.7g}) with lines lw 0.9 lc palette notitle",
                          plot.empty() ? "" : ", \\\n  ", i, value);
    }
    if (plot.empty()) continue;
    plots += fmt::format("set title '{}' offset 0,-0.6\nplot {}\n", look.name, plot);
    ++panels;
  }
  double low = 1e300, high = -1e300;
  for (const auto& [point, curve] : curves) {
    const double value = axis.empty() ? point->row.ordinal : *ReportData::value(*point, axis);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  script += fmt::format("set cbrange [{:.7g}:{:.7g}]\nset xlabel 't, s'\n", low, high > low ? high : low + 1);
  return script + fmt::format("set multiplot layout {},1\n", panels) + plots + "unset multiplot\n";
}

}  // namespace

std::optional<Figure> series_figure(const ReportData& data, const ReportPoint& point) {
  Figure figure;
  figure.name = fmt::format("point-{}", point.row.ordinal);
  figure.title = ordinary_words(point);
  figure.data = gnuplot_comment(fmt::format("{}; a block a cell", columns));
  std::vector<const Curve*> drawn;
  for (const Curve& curve : point.curves) {
    if (!is_drawn(curve)) continue;
    figure.data += block_of(curve, curve.time_s.size(), fmt::format("cell {}", curve.cell));
    drawn.push_back(&curve);
  }
  if (drawn.empty()) return std::nullopt;
  const double end = drawn.front()->time_s.back();
  figure.description = fmt::format(
      "Displacement d and asphericity over {:.4g} s; the window of the averages is shaded.{}", end, ends(point));
  figure.width_px = 520;
  figure.height_px = 340;
  figure.height_cm = 7;
  figure.script = fmt::format(
      "set object 1 rectangle from first {:.7g}, graph 0 to first {:.7g}, graph 1 behind fc rgb '#eeeeee' fs solid "
      "noborder\n",
      std::max(drawn.front()->time_s.front(), end - data.analysis.window_s), end);
  figure.script += "set key top left samplen 1.5\n";
  figure.script += two_panels([&](int column) {
    std::string plots;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      plots +=
          fmt::format("{}'{}.dat' index {} using 1:{} with lines {} title '{}'", i == 0 ? "" : ", \\\n  ", figure.name,
                      i, column, look_of(i), drawn.size() > 1 ? fmt::format("cell {}", drawn[i]->cell) : "");
    return plots;
  });
  return figure;
}

std::optional<Figure> overlay_figure(const ReportData& data, std::size_t most_points) {
  const auto curves = first_curves(data);
  if (curves.empty()) return std::nullopt;
  Figure figure;
  figure.name = "overlay";
  figure.title = "All points over time";
  figure.data = gnuplot_comment(fmt::format("{}; a block a point, its first cell", columns));
  const std::size_t share = std::max<std::size_t>(32, most_points / curves.size());
  for (const auto& [point, curve] : curves) figure.data += block_of(*curve, share, ordinary_words(*point));
  const std::vector<std::string> axes = data.numeric_axes();
  if (curves.size() > most_single_curves) {
    int panels = 0;
    figure.script = grouped_script(curves, axes.empty() ? "" : axes.front(), panels);
    figure.height_px = 90 + 230 * panels;
    figure.height_cm = 1 + 4.5 * panels;
    figure.description = fmt::format("Displacement d over time of {} points, a panel a class, coloured by {}.",
                                     curves.size(), axes.empty() ? "point" : axis_title(axes.front()));
    return figure;
  }
  figure.description = fmt::format(
      "Displacement d (above) and asphericity (below) over time of {} points, each in a colour and a dash of its own.",
      curves.size());
  figure.height_px = 560;
  figure.height_cm = 9.5;
  figure.script = "set key outside right top samplen 2\nset rmargin 24\n";
  figure.script += two_panels([&](int column) {
    std::string plots;
    for (std::size_t i = 0; i < curves.size(); ++i)
      plots += fmt::format("{}'overlay.dat' index {} using 1:{} with lines {} title {}", i == 0 ? "" : ", \\\n  ", i,
                           column, look_of(i), column == 2 ? gnuplot_quoted(curves[i].first->label()) : "''");
    return plots;
  });
  return figure;
}

}  // namespace rouleau::campaign
