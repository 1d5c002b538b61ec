// SPDX-License-Identifier: BSD-3-Clause
// Two views on one scale.
#include "report/channel_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/cell_picture.hpp"
#include "report/cell_tiles.hpp"
#include "report/markup.hpp"

namespace rouleau::campaign {
namespace {

constexpr double width = 2400, margin = 60, wall = 16, heading = 110, footing = 120;
constexpr int tones = 40;

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format(
      "<text x=\"{:.5g}\" y=\"{:.5g}\" font-size=\"48\" font-family=\"sans-serif\" text-anchor=\"{}\" "
      "fill=\"#222222\">{}"
      "</text>\n",
      x, y, anchor, escaped(text));
}

std::string wall_at(double left, double top, double w, double h) {
  return fmt::format("<rect x=\"{:.5g}\" y=\"{:.5g}\" width=\"{:.5g}\" height=\"{:.5g}\" fill=\"#595959\"/>\n", left,
                     top, w, h);
}

std::string line_to(double x, double y, double to_x, double to_y, const char* look) {
  return fmt::format("<path d=\"M{:.5g} {:.5g}L{:.5g} {:.5g}\" fill=\"none\" {}/>\n", x, y, to_x, to_y, look);
}

constexpr const char* axis_look = "stroke=\"#8c8c8c\" stroke-width=\"3\" stroke-dasharray=\"24 8 4 8\"";
constexpr const char* dark_look = "stroke=\"#222222\" stroke-width=\"6\"";

/// The length of a round number of µm that a bar of at most `most_um` shows.
double bar_um(double most_um) {
  for (const double candidate : {50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5})
    if (candidate <= most_um) return candidate;
  return 0.2;
}

}  // namespace

std::string channel_picture(const Shape& shape, const std::string& name) {
  const auto [length, depth, height] = shape.box_um;
  const double window = std::min(length, 3 * std::max(depth, height));
  const double scale = (width - 4 * margin) / (window + depth);
  const double tall = scale * height, top = heading + wall, bottom = top + tall;
  const double side_width = scale * window, front_left = 3 * margin + side_width, front_width = scale * depth;
  const Point3 centre = centre_of(shape.cells.front());
  // Of a channel that is shown whole, both ends are where the simulation's are.
  const double first_um = window < length ? centre[0] - window / 2 : 0;
  const Frame side{scale, first_um, 0, 0, tall}, front{scale, 0, 0, 0, tall};
  std::string sides, fronts;
  for (const CellMesh& cell : shape.cells) {
    fronts += cell_group(cell, front_view, front, tones);
    const double x = centre_of(cell)[0], near = image_near(x, first_um + window / 2, length);
    for (const int period : {-1, 0, 1}) {  // a cell on the seam is seen at both ends
      CellMesh image = cell;
      double low = 1e300, high = -1e300;
      for (Point3& vertex : image.vertices_um) {
        vertex[0] += near - x + period * length;
        low = std::min(low, vertex[0]);
        high = std::max(high, vertex[0]);
      }
      if (high > first_um && low < first_um + window) sides += cell_group(image, side_view, side, tones);
    }
  }
  const double d = displacement_um(shape, shape.cells.front());
  const std::string caption = fmt::format("{}, t = {:.4g} s, d = {:.2f} µm", name, shape.time_s, d);
  std::string text = svg_file_head(
      width, bottom + wall + footing, caption,
      fmt::format(
          "The cell in its channel. Left: side view, the flow goes to the right, walls above and below. Right: front "
          "view in walls of {:g} by {:g} µm, the flow comes towards the eye.",
          depth, height));
  const auto view = [&](double left, double w, const std::string& inner) {
    text += fmt::format("<svg x=\"{:.5g}\" y=\"{:.5g}\" width=\"{:.5g}\" height=\"{:.5g}\">{}</svg>\n", left, top, w,
                        tall, inner);
  };
  const double middle = top + tall / 2, front_middle = front_left + front_width / 2;
  text += text_at(margin, 62, "start", caption);
  text += line_to(margin, middle, margin + side_width, middle, axis_look);
  text += line_to(front_middle, top, front_middle, bottom, axis_look) +
          line_to(front_left, middle, front_left + front_width, middle, axis_look);
  view(margin, side_width, sides);
  view(front_left, front_width, fronts);
  text += wall_at(margin, top - wall, side_width, wall) + wall_at(margin, bottom, side_width, wall);
  text += wall_at(front_left - wall, top - wall, front_width + 2 * wall, wall) +
          wall_at(front_left - wall, bottom, front_width + 2 * wall, wall) +
          wall_at(front_left - wall, top, wall, tall) + wall_at(front_left + front_width, top, wall, tall);

  const double base = bottom + wall + 70;
  text += line_to(margin, base - 16, margin + 180, base - 16, dark_look);
  text += fmt::format("<path d=\"M{0:.5g} {1:.5g}l-36 -20v40z\" fill=\"#222222\"/>\n", margin + 200, base - 16);
  text += text_at(margin + 220, base, "start", "flow");
  const double bar = bar_um(window / 3), bar_right = margin + side_width, bar_left = bar_right - scale * bar;
  text += line_to(bar_left, base - 16, bar_right, base - 16, "stroke=\"#222222\" stroke-width=\"12\"");
  text += text_at(bar_left - 20, base, "end", fmt::format("{:g} µm", bar));
  text += fmt::format(
      "<circle cx=\"{0:.5g}\" cy=\"{1:.5g}\" r=\"22\" fill=\"none\" stroke=\"#222222\" stroke-width=\"6\"/>"
      "<circle cx=\"{0:.5g}\" cy=\"{1:.5g}\" r=\"7\" fill=\"#222222\"/>\n",
      front_left + 26, base - 16);
  text += text_at(front_left + 64, base, "start", "towards the eye");
  return text + "</svg>\n";
}

}  // namespace rouleau::campaign
