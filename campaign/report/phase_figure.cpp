// SPDX-License-Identifier: BSD-3-Clause
// One data file of classified points, a plot a class.
#include "report/phase_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/boundary.hpp"
#include "report/gnuplot_text.hpp"
#include "report/palette.hpp"
#include "report/parameter_words.hpp"

namespace rouleau::campaign {
namespace {

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

/// One `plot` element a class and state that occurs, in columns x:y of block 0.
std::string marker_plots(const std::string& file, const std::vector<Marker>& markers, const char* columns,
                         bool with_errors) {
  std::string plots;
  for (std::size_t look = 0; look < class_looks.size(); ++look) {
    const ClassLook& is = class_looks[look];
    for (const bool is_done : {true, false}) {
      const auto occurs = [&](const Marker& m) { return m.look == look && m.is_done == is_done; };
      if (std::none_of(markers.begin(), markers.end(), occurs)) continue;
      const std::string only =
          fmt::format("'{}' index 0 using ($5 == {} && $6 == {:d} ? $1 : NaN):", file, look, is_done);
      const bool has_error = std::any_of(markers.begin(), markers.end(),
                                         [&](const Marker& m) { return occurs(m) && m.error_um.has_value(); });
      if (with_errors && has_error)
        plots += fmt::format(", \\\n  {}3:4 with yerrorbars pt 0 ps 0 lw 1.2 lc rgb '{}' notitle", only, is.colour);
      plots += fmt::format(", \\\n  {}{} with points pt {} ps 1.1 lc rgb '{}' title '{}{}'", only, columns,
                           is_done ? is.filled : is.open, is.colour, is.name, is_done ? "" : ", not done");
    }
  }
  return plots;
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
  constexpr const char* line = ", \\\n  {:.7g} with lines dt 3 lw 0.8 lc rgb '{}' {}";
  return fmt::format(fmt::runtime(line), analysis.croissant_d_um, grey, "title 'thresholds'") +
         fmt::format(fmt::runtime(line), analysis.slipper_d_um, grey, "notitle");
}

/// The markers' second values, each with a line through its markers in a block of its own.
std::string add_lines(Figure& figure, std::vector<Marker> markers, const std::string& axis) {
  std::set<double> rows;
  for (const Marker& m : markers) rows.insert(m.y);
  std::stable_sort(markers.begin(), markers.end(), [](const Marker& a, const Marker& b) { return a.x < b.x; });
  std::string plots;
  int block = 0;
  for (const double y : rows) {
    figure.data += "\n\n" + gnuplot_comment(fmt::format("x, d_mean_um at {} = {}", axis, y));
    for (const Marker& m : markers)
      if (m.y == y) figure.data += fmt::format("{} {}\n", gnuplot_number(m.x), gnuplot_number(m.d_um));
    ++block;
    plots += fmt::format("{}'{}.dat' index {} using 1:2 with lines lw 0.8 dt {} lc rgb '#8c8c8c' title {}",
                         plots.empty() ? "" : ", \\\n  ", figure.name, block, 1 + (block - 1) % 5,
                         rows.size() > 10 ? "''" : gnuplot_quoted(parameter_words(axis, fmt::format("{:.6g}", y))));
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
  std::string plots = axes.size() > 1 ? add_lines(figure, markers, axes[1])
                                      : "'phase.dat' index 0 using 1:3 with lines lw 0.8 lc rgb '#b3b3b3' notitle";
  plots += threshold_plots(data.analysis) + marker_plots("phase.dat", markers, "3", true);
  figure.script =
      fmt::format("set xlabel {}\nset ylabel 'd, µm'\nset xrange {}\nset yrange [0:*]\nset offsets 0,0,0.05,0\n",
                  gnuplot_quoted(x), range_of(markers, &Marker::x));
  figure.script += "set key outside top center horizontal maxrows 3 samplen 1.5\nplot " + plots + "\n";
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
      "and the first slipper of a row, its bars from one to the other; {} such changes.",
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
  plots += marker_plots("map.dat", markers, "2", false);
  if (plots.starts_with(", \\\n  ")) plots.erase(0, 6);
  figure.script = fmt::format("set xlabel {}\nset ylabel {}\nset xrange {}\nset yrange {}\n", gnuplot_quoted(x),
                              gnuplot_quoted(y), range_of(markers, &Marker::x), range_of(markers, &Marker::y));
  figure.script += "set key outside top center horizontal maxrows 3 samplen 1.5\nplot " + plots + "\n";
  return figure;
}

}  // namespace rouleau::campaign
