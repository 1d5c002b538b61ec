// SPDX-License-Identifier: BSD-3-Clause
// One data file of classified points, a plot a class.
#include "report/phase_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "report/boundary.hpp"
#include "report/gnuplot_text.hpp"
#include "report/palette.hpp"
#include "report/parameter_words.hpp"

namespace rouleau::campaign {
namespace {

/// Values of a second axis up to which each has a line in the key; the map shows them better.
constexpr std::size_t most_named_rows = 4;

/// A marker: one cell of a point.
struct Marker {
  double x = 0, y = 0;
  std::optional<double> d_um, error_um;
  std::size_t look = 2;  ///< into class_looks
  bool is_done = false;
  int ordinal = 0;
};

std::size_t look_of(const std::string& phase) {
  for (std::size_t i = 0; i < class_looks.size(); ++i)
    if (class_looks[i].name == phase) return i;
  return 2;
}

std::vector<Marker> markers_of(const ReportData& data, const std::vector<std::string>& axes) {
  std::vector<Marker> markers;
  for (const ReportPoint& point : data.points) {
    for (const ResultRow& cell : point.results) {
      Marker marker;
      marker.x = !axes.empty() ? *ReportData::value(point, axes[0]) : point.lambda.value_or(point.row.ordinal);
      if (axes.size() > 1) marker.y = *ReportData::value(point, axes[1]);
      marker.d_um = cell.d_mean_um;
      marker.error_um = cell.d_error_um;
      marker.look = look_of(cell.phase);
      marker.is_done = point.row.state == State::done;
      marker.ordinal = point.row.ordinal;
      if (marker.d_um) markers.push_back(marker);
    }
  }
  return markers;
}

std::string x_title(const ReportData& data, const std::vector<std::string>& axes) {
  if (!axes.empty()) return axis_title(axes.front());
  const bool has_lambda = std::all_of(data.points.begin(), data.points.end(),
                                      [](const ReportPoint& point) { return point.lambda.has_value(); });
  return has_lambda ? "λ" : "point";
}

std::string counts(const std::vector<Marker>& markers) {
  std::string text;
  for (std::size_t look = 0; look < class_looks.size(); ++look) {
    const auto count = std::count_if(markers.begin(), markers.end(), [&](const Marker& m) { return m.look == look; });
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, class_looks[look].name);
  }
  return text;
}

/// One `plot` element a class and state that occurs, d with errors or y over x.
std::string marker_plots(const std::string& file, const std::vector<Marker>& markers, bool with_errors) {
  std::string plots;
  for (std::size_t look = 0; look < class_looks.size(); ++look) {
    const ClassLook& is = class_looks[look];
    for (const bool is_done : {true, false}) {
      const auto occurs = [&](const Marker& m) { return m.look == look && m.is_done == is_done; };
      if (std::none_of(markers.begin(), markers.end(), occurs)) continue;
      const std::string only =
          fmt::format("'{}' index 0 using ($5 == {} && $6 == {:d} ? $1 : NaN):", file, look, is_done);
      const std::string marker = fmt::format("pt {} ps 1.1 lc rgb '{}' title '{}{}'", is_done ? is.filled : is.open,
                                             is.colour, is.name, is_done ? "" : ", not done");
      // x == x is false for NaN: a point without an error is drawn all the same.
      plots += with_errors ? fmt::format(", \\\n  {}3:($4 == $4 ? $4 : 0) with yerrorbars lw 1.2 {}", only, marker)
                           : fmt::format(", \\\n  {}2 with points {}", only, marker);
    }
  }
  return plots;
}

/// Makes room for a key above the plot: three short names a line, or one long one.
void add_key(Figure& figure, const std::string& plots) {
  int names = 0;
  std::size_t longest = 0;
  for (std::size_t at = 0; (at = plots.find(" title '", at)) != std::string::npos;) {
    at += 8;
    const std::size_t length = plots.find('\'', at) - at;
    longest = std::max(longest, length);
    names += length > 0 ? 1 : 0;
  }
  const int lines = longest > 20 ? names : (names + 2) / 3;
  figure.height_px += 22.0 * lines;
  figure.script += fmt::format("set key outside top center horizontal maxrows {} samplen 1.5\n", lines);
}

std::string marker_data(const std::vector<Marker>& markers, const std::string& x, const std::string& y) {
  std::string text =
      gnuplot_comment(fmt::format("x ({}), y ({}), d_mean_um, d_error_um, class (0 croissant, 1 slipper, "
                                  "2 undecided), done (0 or 1), point",
                                  x, y));
  for (const Marker& m : markers)
    text += fmt::format("{} {} {} {} {} {:d} {}\n", gnuplot_number(m.x), gnuplot_number(m.y), gnuplot_number(m.d_um),
                        gnuplot_number(m.error_um), m.look, m.is_done, m.ordinal);
  return text;
}

/// A range with some room around the markers, also when they are all at one place.
std::string range_of(const std::vector<Marker>& markers, double Marker::*member) {
  double low = markers.front().*member, high = low;
  for (const Marker& m : markers) {
    low = std::min(low, m.*member);
    high = std::max(high, m.*member);
  }
  const double room = high > low ? 0.06 * (high - low) : std::max(0.1, 0.1 * std::abs(low));
  return fmt::format("[{:.7g}:{:.7g}]", low - room, high + room);
}

std::string threshold_plots(const Analysis& analysis) {
  return fmt::format(
      "{0:.7g} with lines dt 3 lw 0.8 lc rgb '{2}' title 'thresholds', \\\n  {1:.7g} with lines dt 3 lw 0.8 lc "
      "rgb '{2}' notitle",
      analysis.croissant_d_um, analysis.slipper_d_um, grey);
}

/// Lines through the points that are done, one for each value of the second axis if there is one, each in a block of
/// its own.
std::string add_lines(Figure& figure, std::vector<Marker> markers, const std::vector<std::string>& axes) {
  std::erase_if(markers, [](const Marker& m) { return !m.is_done; });
  std::stable_sort(markers.begin(), markers.end(), [](const Marker& a, const Marker& b) { return a.x < b.x; });
  std::map<double, std::vector<Marker>> rows;
  for (const Marker& m : markers) rows[m.y].push_back(m);
  std::string plots;
  int block = 0;
  for (const auto& [y, row] : rows) {
    if (row.size() < 2) continue;
    const std::string name = axes.size() > 1 ? parameter_words(axes[1], fmt::format("{:.6g}", y)) : "all";
    ++block;
    figure.data += "\n\n" + gnuplot_comment("x, d_mean_um of the points that are done: " + name);
    for (const Marker& m : row) figure.data += fmt::format("{} {}\n", gnuplot_number(m.x), gnuplot_number(m.d_um));
    plots += fmt::format(", \\\n  '{}.dat' index {} using 1:2 with lines lw 0.8 dt {} lc rgb '#8c8c8c' title {}",
                         figure.name, block, 1 + (block - 1) % 5,
                         axes.size() < 2 || rows.size() > most_named_rows ? "''" : gnuplot_quoted(name));
  }
  return plots;
}

}  // namespace

std::optional<Figure> phase_figure(const ReportData& data) {
  const std::vector<std::string> axes = data.numeric_axes();
  const std::vector<Marker> markers = markers_of(data, axes);
  if (markers.empty()) return std::nullopt;
  const std::string x = x_title(data, axes);
  Figure figure;
  figure.name = "phase";
  figure.title = fmt::format("Displacement against {}", x);
  figure.description = fmt::format(
      "Mean displacement d of the cell from the channel axis over the last {:g} s against {}, "
      "with standard errors: {} of {} points. Dotted: below {:g} µm croissant, above {:g} µm "
      "slipper.",
      data.analysis.window_s, x, counts(markers), data.points.size(), data.analysis.croissant_d_um,
      data.analysis.slipper_d_um);
  figure.data = marker_data(markers, x, axes.size() > 1 ? axis_title(axes[1]) : "none");
  const std::string lines = add_lines(figure, markers, axes);
  const std::string plots = threshold_plots(data.analysis) + lines + marker_plots("phase.dat", markers, true);
  figure.script =
      fmt::format("set xlabel {}\nset ylabel 'd, µm'\nset xrange {}\nset yrange [0:*]\nset offsets 0,0,0.05,0\n",
                  gnuplot_quoted(x), range_of(markers, &Marker::x));
  add_key(figure, plots);
  figure.script += "plot " + plots + "\n";
  return figure;
}

std::optional<Figure> map_figure(const ReportData& data) {
  const std::vector<std::string> axes = data.numeric_axes();
  if (axes.size() < 2) return std::nullopt;
  const std::vector<Marker> markers = markers_of(data, axes);
  std::set<double> xs, ys;
  std::vector<Classified> classified;
  for (const Marker& m : markers) {
    xs.insert(m.x);
    ys.insert(m.y);
    classified.push_back({m.x, m.y, std::string(class_looks[m.look].name)});
  }
  if (xs.size() < 2 || ys.size() < 2) return std::nullopt;
  const std::vector<Crossing> crossings = boundary(classified);
  const std::string x = axis_title(axes[0]), y = axis_title(axes[1]);
  Figure figure;
  figure.name = "map";
  figure.title = fmt::format("Classes over {} and {}", x, y);
  figure.description = fmt::format(
      "Class of each point over {} and {}: {}. The line runs midway between the last croissant "
      "and the first slipper of a row, its bars from one to the other; number of such changes: {}.",
      x, y, counts(markers), crossings.size());
  figure.data = marker_data(markers, x, y);
  std::string plots;
  if (!crossings.empty()) {
    figure.data += "\n\n" + gnuplot_comment("boundary: x midway, y, x of one class, x of the other");
    for (const Crossing& c : crossings)
      figure.data += fmt::format("{:.7g} {:.7g} {:.7g} {:.7g}\n", (c.low + c.high) / 2, c.y, c.low, c.high);
    plots =
        "'map.dat' index 1 using 1:2 with lines lw 2 lc rgb '#404040' title 'boundary', \\\n"
        "  'map.dat' index 1 using 1:2:3:4 with xerrorbars pt 0 ps 0 lw 1 lc rgb '#404040' notitle";
  }
  plots += marker_plots("map.dat", markers, false);
  if (plots.starts_with(", \\\n  ")) plots.erase(0, 6);
  figure.script = fmt::format("set xlabel {}\nset ylabel {}\nset xrange {}\nset yrange {}\n", gnuplot_quoted(x),
                              gnuplot_quoted(y), range_of(markers, &Marker::x), range_of(markers, &Marker::y));
  add_key(figure, plots);
  figure.script += "plot " + plots + "\n";
  return figure;
}

}  // namespace rouleau::campaign
