// SPDX-License-Identifier: BSD-3-Clause
// Frames of two views, and of nodes.
#include "report/cell_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/cell_picture.hpp"
#include "report/inline_svg.hpp"
#include "report/markup.hpp"
#include "report/palette.hpp"

namespace rouleau::campaign {
namespace {

constexpr double tile_width = 240, text_height = 30, gap = 10;
constexpr int tones = 12;
constexpr const char* wall_look = "fill=\"none\" stroke=\"#222222\" stroke-width=\"3\"";
constexpr double grain_um = 0.42;  // a cell of 4 um in radius keeps about 1400 triangles

std::string text_at(double x, double y, const std::string& text) {
  return fmt::format(
      "<text x=\"{:g}\" y=\"{:g}\" font-size=\"22\" font-family=\"sans-serif\" text-anchor=\"middle\" "
      "fill=\"#222222\">{}"
      "</text>\n",
      x, y, escaped(text));
}

}  // namespace

double image_near(double x, double near, double period) { return x - period * std::round((x - near) / period); }

std::string svg_file_head(double width, double height, const std::string& title, const std::string& description) {
  std::string head = svg_head("picture", fmt::format("0 0 {:g} {:g}", width, height), title, description);
  head.insert(4, fmt::format(" xmlns=\"http://www.w3.org/2000/svg\" width=\"{:g}\" height=\"{:g}\"", width, height));
  return head + "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

double window_um(const Shape& shape) {
  double low = 1e300, high = -1e300;
  for (const Point3& vertex : shape.cells.front().vertices_um) {
    low = std::min(low, vertex[0]);
    high = std::max(high, vertex[0]);
  }
  return std::min(shape.box_um[0], std::max(10.0, 1.25 * (high - low)));
}

Tile shape_tile(const Shape& shape, double window, const std::string& id) {
  const double scale = tile_width / std::max(window, shape.box_um[1]);
  const double height = scale * shape.box_um[2];
  const double centre_x = centre_of(shape.cells.front())[0];
  const Frame side{scale, centre_x - window / 2, 0, 0, height}, front{scale, 0, 0, 0, height};
  std::string sides, fronts;
  for (const CellMesh& cell : shape.cells) {
    CellMesh coarse = coarsened(cell, grain_um);
    const double x = centre_of(cell)[0], shift = image_near(x, centre_x, shape.box_um[0]) - x;
    for (Point3& vertex : coarse.vertices_um) vertex[0] += shift;
    sides += cell_group(coarse, side_view, side, tones);
    fronts += cell_group(coarse, front_view, front, tones);
  }
  const double side_width = scale * window, front_width = scale * shape.box_um[1];
  const double side_left = (tile_width - side_width) / 2, front_left = (tile_width - front_width) / 2;
  Tile tile{tile_width, 2 * height + 3 * gap + text_height, ""};
  // Another cell may reach out of the window; what does is cut off.
  tile.body = fmt::format("<clipPath id=\"{}-window\"><rect width=\"{:.4g}\" height=\"{:.4g}\"/></clipPath>\n", id,
                          side_width, height);
  tile.body += fmt::format("<g transform=\"translate({:.4g} {:g})\"><g clip-path=\"url(#{}-window)\">{}</g>", side_left,
                           gap, id, sides);
  tile.body += fmt::format("<path d=\"M0 0h{0:.4g}M0 {1:.4g}h{0:.4g}\" {2}/></g>\n", side_width, height, wall_look);
  tile.body +=
      fmt::format("<g transform=\"translate({:.4g} {:.4g})\">{}<rect width=\"{:.4g}\" height=\"{:.4g}\" {}/></g>\n",
                  front_left, height + 2 * gap, fronts, front_width, height, wall_look);
  tile.body += text_at(tile_width / 2, tile.height - 8,
                       fmt::format("{:.3g} s, d {:.2f} µm", shape.time_s, displacement_um(shape, shape.cells[0])));
  return tile;
}

Tile slice_tile(const Shape& shape, double window) {
  const FlagSlice& slice = shape.slice.value();
  const std::size_t up = slice.normal == 1 ? 2 : 1;
  const double scale = 480 / window;
  const double centre_x = centre_of(shape.cells.front())[0];
  const Frame frame{scale, centre_x - window / 2, 0, 0, scale * shape.box_um[up] + gap};
  const double node = scale * slice.spacing_um;
  std::string inside, outside;
  for (std::size_t k = 0; k < slice.rows.size(); ++k)
    for (std::size_t i = 0; i < slice.rows[k].size(); ++i) {
      const double x_um =
          image_near(slice.first_node_um + slice.spacing_um * static_cast<double>(i), centre_x, shape.box_um[0]);
      if (std::abs(x_um - centre_x) > window / 2 - slice.spacing_um) continue;
      const double x = frame.x(x_um), y = frame.y(slice.first_node_um + slice.spacing_um * static_cast<double>(k));
      if (slice.rows[k][i] == '1')
        inside += fmt::format("M{:.4g} {:.4g}h{:.3g}v{:.3g}h-{:.3g}z", x - 0.36 * node, y - 0.36 * node, 0.72 * node,
                              0.72 * node, 0.72 * node);
      else
        outside += fmt::format("M{:.4g} {:.4g}h0", x, y);
    }
  std::string membrane;
  for (const CellMesh& cell : shape.cells) {
    const double x = centre_of(cell)[0], shift = image_near(x, centre_x, shape.box_um[0]) - x;
    for (const auto& [a, b] : cut(cell, slice.normal, slice.at_um))
      membrane += fmt::format("M{:.4g} {:.4g}L{:.4g} {:.4g}", frame.x(a[0] + shift), frame.y(a[up]),
                              frame.x(b[0] + shift), frame.y(b[up]));
  }
  Tile tile{480, frame.bottom + gap + text_height, ""};
  tile.body = fmt::format("<path d=\"{}\" stroke=\"#8c8c8c\" stroke-width=\"{:.3g}\" stroke-linecap=\"round\"/>\n",
                          outside, 0.22 * node);
  tile.body += fmt::format(
      "<path d=\"{}\" fill=\"{}\"/>\n<path d=\"{}\" stroke=\"#000000\" stroke-width=\"3\" fill=\"none\" "
      "stroke-linecap=\"round\"/>\n",
      inside, orange, membrane);
  tile.body += fmt::format("<path d=\"M0 {:.4g}h480M0 {:.4g}h480\" stroke=\"#222222\" stroke-width=\"4\"/>",
                           frame.y(shape.box_um[up]), frame.y(0));
  tile.body += text_at(
      240, tile.height - 8,
      fmt::format("t = {:.3g} s, slice at {} = {:.2f} µm", shape.time_s, slice.normal == 1 ? "y" : "z", slice.at_um));
  return tile;
}

std::string tile_element(const Tile& tile, const std::string& id, const std::string& title,
                         const std::string& description) {
  return svg_head(id, fmt::format("0 0 {:g} {:.4g}", tile.width, tile.height), title, description) + tile.body +
         "</svg>\n";
}

std::string film_strip(const std::vector<Shape>& shapes, const std::string& name) {
  std::vector<Tile> tiles;
  double row_height = 0;
  double window = 0;
  for (const Shape& shape : shapes) window = std::max(window, window_um(shape));
  for (const Shape& shape : shapes) {
    tiles.push_back(shape_tile(shape, window, fmt::format("picture-{}", tiles.size())));
    row_height = std::max(row_height, tiles.back().height);
  }
  const std::size_t columns = std::min<std::size_t>(6, std::max<std::size_t>(3, tiles.size()));
  const std::size_t rows = (tiles.size() + columns - 1) / columns;
  const double width = static_cast<double>(columns) * (tile_width + 2 * gap), heading = 44;
  std::string text = svg_file_head(
      width, heading + static_cast<double>(rows) * row_height + gap, name,
      fmt::format("{} pictures of the cell, from {:.4g} s to {:.4g} s; side view above, front view below.",
                  tiles.size(), shapes.front().time_s, shapes.back().time_s));
  text += text_at(width / 2, 32, name);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double left = static_cast<double>(i % columns) * (tile_width + 2 * gap) + gap;
    const double top = heading + static_cast<double>(i / columns) * row_height;
    text += fmt::format("<g transform=\"translate({:.5g} {:.5g})\">{}</g>\n", left, top, tiles[i].body);
  }
  return text + "</svg>\n";
}

}  // namespace rouleau::campaign
