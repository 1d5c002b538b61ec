// SPDX-License-Identifier: BSD-3-Clause
// Small pictures of a cell in its channel, for rows of them.
#pragma once

#include <string>
#include <vector>

#include "report/cell_shape.hpp"

namespace rouleau::campaign {

/// What lies inside an <svg> of this size.
struct Tile {
  double width = 0, height = 0;
  std::string body;
};

/// How wide a window along x shows the first cell with room around it.
[[nodiscard]] double window_um(const Shape& shape);

/// Side view (the flow goes to the right) above the front view, walls as lines, the time below. Tiles of the same
/// window and channel are of one scale. Triangles are made coarser: a tile takes about 20 kB. `id` is unique in the
/// page.
[[nodiscard]] Tile shape_tile(const Shape& shape, double window, const std::string& id);

/// The flags of a slice around the first cell: squares inside, dots outside, the membrane as a line.
/// Needs shape.slice.
[[nodiscard]] Tile slice_tile(const Shape& shape, double window);

/// A tile as an element of a page. `id` is unique there.
[[nodiscard]] std::string tile_element(const Tile& tile, const std::string& id, const std::string& title,
                                       const std::string& description);

/// The same cell at several times, in rows of at most six tiles: a complete SVG file.
[[nodiscard]] std::string film_strip(const std::vector<Shape>& shapes, const std::string& name);

/// The nearest periodic image of x to `near`.
[[nodiscard]] double image_near(double x, double near, double period);

/// The beginning of a complete SVG file with a white ground.
[[nodiscard]] std::string svg_file_head(double width, double height, const std::string& title,
                                        const std::string& description);

}  // namespace rouleau::campaign
