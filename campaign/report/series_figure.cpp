// SPDX-License-Identifier: BSD-3-Clause
// Blocks of time, d and asphericity; two panels over one time axis.
#include "report/series_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "report/fit_text.hpp"
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

/// At most six tics from 0 to `end`.
std::string time_tics(double end) {
  double step = std::pow(10, std::floor(std::log10(std::max(end, 1e-9) / 5)));
  for (const double factor : {2.0, 2.5, 2.0})
    if (end / step > 5.5) step *= factor;
  return fmt::format("set xtics {:.3g}\n", step);
}

/// Two panels of equal height, `plots(column)` in each; above them `rows` lines of a key of so many columns.
template <class Plots>
std::string two_panels(double height_px, int rows, int columns_of_key, const Plots& plots) {
  std::string script = "set multiplot\nset lmargin 10\nset rmargin 2\nset yrange [0:*]\nset tmargin 0\nset bmargin 0\n";
  script +=
      rows > 0
          ? fmt::format("set key at screen 0.98, screen 0.995 top right horizontal maxcols {} samplen 2.5 width -1\n",
                        columns_of_key)
          : "unset key\n";
  script += fmt::format("bottom = {:.4g}\ntop = {:.4g}\nmiddle = (bottom + top) / 2\n", 66 / height_px,
                        1 - (12 + 26 * rows) / height_px);
  script +=
      "set tmargin at screen top\nset bmargin at screen middle + 0.02\nset format x ''\nset ylabel 'd, µm'\nplot " +
      plots(2);
  script +=
      "\nset tmargin at screen middle - 0.02\nset bmargin at screen bottom\nset format x '%g'\nset xlabel 't, s' "
      "offset 0,0.4\n";
  return script + "unset key\nset ylabel 'asphericity'\nplot " + plots(3) + "\nunset multiplot\n";
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

/// A swept parameter as short as a legend needs it: four digits, and a word without its name ("2-point").
std::string short_words(const ReportPoint& point, const std::string& axis) {
  for (const ParameterRow& row : point.swept) {
    if (row.name != axis) continue;
    if (row.value) return parameter_words(axis, fmt::format("{:.4g}", *row.value));
    const bool is_word = std::any_of(row.text.begin(), row.text.end(), [](unsigned char c) { return std::isalpha(c); });
    return is_word ? row.text : parameter_words(axis, row.text);
  }
  return "";
}

bool is_number(const std::vector<std::pair<const ReportPoint*, const Curve*>>& curves, const std::string& axis) {
  return std::any_of(curves.begin(), curves.end(),
                     [&](const auto& curve) { return ReportData::value(*curve.first, axis).has_value(); });
}

/// The points by the axes that tell them apart: λ, then words, then numbers, and none that splits nothing that those
/// before it have not split. gnuplot drops an entry without a word if it is wider than the figure.
std::vector<std::string> legends(const std::vector<std::pair<const ReportPoint*, const Curve*>>& curves,
                                 std::vector<std::string> axes) {
  constexpr std::size_t widest = 36;
  std::stable_partition(axes.begin(), axes.end(), [&](const std::string& axis) { return !is_number(curves, axis); });
  std::stable_partition(axes.begin(), axes.end(), [](const std::string& axis) { return axis == "fluid.lambda"; });
  std::vector<std::string> names(curves.size());
  std::size_t kinds = 1;
  for (const std::string& axis : axes) {
    std::vector<std::string> longer = names;
    for (std::size_t i = 0; i < curves.size(); ++i)
      longer[i] += (names[i].empty() ? "" : ", ") + short_words(*curves[i].first, axis);
    const std::size_t longer_kinds = std::set<std::string>(longer.begin(), longer.end()).size();
    if (longer_kinds > kinds) names = std::move(longer);
    kinds = std::max(kinds, longer_kinds);
  }
  const bool are_cut =
      std::any_of(names.begin(), names.end(), [](const std::string& name) { return shown_width(name) > widest; });
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (are_cut || kinds < curves.size())
      names[i] = fmt::format("#{}{}{}", curves[i].first->row.ordinal, names[i].empty() ? "" : " ", names[i]);
    names[i] = fitted(names[i], widest);
  }
  return names;
}

/// Colour and dash, of which neighbours share neither.
std::string look_of(std::size_t i) {
  constexpr std::array<int, 4> dashes = {1, 2, 4, 5};
  return fmt::format("lw 1.4 lc rgb '{}' dt {}", curve_colours[i % curve_colours.size()], dashes[i % dashes.size()]);
}

/// Of the palette cividis, which the colour-blind see as others do, what is dark enough on white.
constexpr std::string_view dark_to_light =
    "0 '#00224E', 1 '#123570', 2 '#3B496C', 3 '#575D6D', 4 '#707173', 5 '#8A8678', 6 '#A59C74', 7 '#C3B369'";

/// Two panels a class, coloured by an axis.
std::string grouped_script(const std::vector<std::pair<const ReportPoint*, const Curve*>>& curves,
                           const std::string& axis, int& panels) {
  std::string script = fmt::format(
      "set palette defined ({})\nset cblabel {}\nset yrange [0:*]\nset lmargin 10\nset rmargin 9\nset tmargin 1.6\nset "
      "bmargin 2.8\n",
      dark_to_light, gnuplot_quoted(axis.empty() ? "point" : axis_title(axis)));
  std::string plots;
  panels = 0;
  for (const ClassLook& look : class_looks) {
    std::array<std::string, 2> plot;  // of d and of asphericity
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const ReportPoint& point = *curves[i].first;
      const bool belongs = point.result() != nullptr ? point.result()->phase == look.name : look.name == "undecided";
      if (!belongs) continue;
      const double value = axis.empty() ? point.row.ordinal : *ReportData::value(point, axis);
      for (std::size_t k = 0; k < plot.size(); ++k)
        plot[k] += fmt::format("{}'overlay.dat' index {} using 1:{}:({:.7g}) with lines lw 0.9 lc palette notitle",
                               plot[k].empty() ? "" : ", \\\n  ", i, k + 2, value);
    }
    if (plot[0].empty()) continue;
    plots += fmt::format("set title '{}' offset 0,-0.6\nset ylabel 'd, µm'\nplot {}\n", look.name, plot[0]);
    plots += fmt::format("set ylabel 'asphericity'\nplot {}\n", plot[1]);
    panels += 2;
  }
  double low = 1e300, high = -1e300;
  for (const auto& [point, curve] : curves) {
    const double value = axis.empty() ? point->row.ordinal : *ReportData::value(*point, axis);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  high = high > low ? high : low + 1;
  script += fmt::format("set cbrange [{0:.7g}:{1:.7g}]\nset cbtics {0:.7g},{2:.7g}\nset xlabel 't, s' offset 0,0.5\n",
                        low, high, (high - low) / 2);
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
  figure.width_px = 440;
  figure.height_px = 360;
  figure.height_cm = 7;
  figure.script = fmt::format(
      "set object 1 rectangle from first {:.7g}, graph 0 to first {:.7g}, graph 1 behind fc rgb '#eeeeee' fs solid "
      "noborder\n",
      std::max(drawn.front()->time_s.front(), end - data.analysis.window_s), end);
  figure.script += time_tics(end);
  figure.script += two_panels(figure.height_px, drawn.size() > 1 ? 1 + static_cast<int>(drawn.size() - 1) / 4 : 0, 4,
                              [&](int column) {
                                std::string plots;
                                for (std::size_t i = 0; i < drawn.size(); ++i)
                                  plots += fmt::format("{}'{}.dat' index {} using 1:{} with lines {} title '{}'",
                                                       i == 0 ? "" : ", \\\n  ", figure.name, i, column, look_of(i),
                                                       drawn.size() > 1 ? fmt::format("cell {}", drawn[i]->cell) : "");
                                return plots;
                              });
  return figure;
}

std::optional<Figure> overlay_figure(const ReportData& data, std::size_t most_points) {
  const auto curves = first_curves(data);
  if (curves.size() < 2) return std::nullopt;
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
    figure.height_px = 60 + 190 * panels;
    figure.height_cm = 1 + 3.6 * panels;
    figure.description =
        fmt::format("Displacement d and asphericity over time of {} points, two panels a class, coloured by {}.",
                    curves.size(), axes.empty() ? "point" : axis_title(axes.front()));
    return figure;
  }
  figure.description = fmt::format(
      "Displacement d (above) and asphericity (below) over time of {} points, each in a colour and a dash of its own.",
      curves.size());
  figure.height_px = 520;
  figure.height_cm = 9.5;
  std::size_t longest = 1;
  const std::vector<std::string> names = legends(curves, data.swept);
  for (const std::string& name : names) longest = std::max(longest, shown_width(name));
  const int columns_of_key = std::clamp(static_cast<int>(44 / (longest + 7)), 1, 5);
  const int rows = (static_cast<int>(curves.size()) + columns_of_key - 1) / columns_of_key;
  figure.height_px += 26.0 * rows;
  double end = 0;
  for (const auto& [point, curve] : curves) end = std::max(end, curve->time_s.back());
  figure.script =
      time_tics(end) + two_panels(figure.height_px, rows, columns_of_key, [&](int column) {
        std::string plots;
        for (std::size_t i = 0; i < curves.size(); ++i)
          plots += fmt::format("{}'overlay.dat' index {} using 1:{} with lines {} title {}", i == 0 ? "" : ", \\\n  ",
                               i, column, look_of(i), column == 2 ? gnuplot_quoted(names[i]) : "''");
        return plots;
      });
  return figure;
}

}  // namespace rouleau::campaign
