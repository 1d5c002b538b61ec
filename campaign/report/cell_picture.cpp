// SPDX-License-Identifier: BSD-3-Clause
// The painter's algorithm for closed surfaces: what looks away is left out, slabs of depth are painted in turn.
#include "report/cell_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rouleau::campaign {
namespace {

constexpr int slabs = 24;

/// From shadow to light: vermillion, darker and lighter.
std::string tone_colour(int tone, int tones) {
  constexpr std::array<double, 3> dark = {0x6B, 0x24, 0x00}, middle = {0xD5, 0x5E, 0x00}, light = {0xFF, 0xD2, 0xB0};
  const double place = static_cast<double>(tone) / (tones - 1);
  std::array<int, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = place < 0.6 ? dark[k] + (middle[k] - dark[k]) * place / 0.6
                                     : middle[k] + (light[k] - middle[k]) * (place - 0.6) / 0.4;
    colour[k] = static_cast<int>(std::lround(value));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

struct Facet {
  int slab = 0, tone = 0;
  std::array<std::array<long, 2>, 3> corners{};
};

std::string path_of(const Facet& facet) {
  const auto& c = facet.corners;
  return fmt::format("M{} {}l{} {} {} {}z", c[0][0], c[0][1], c[1][0] - c[0][0], c[1][1] - c[0][1], c[2][0] - c[1][0],
                     c[2][1] - c[1][1]);
}

/// Facets that face the eye, with depth not yet cut into slabs.
struct Eye {
  std::size_t right, up, depth;
  double towards;  ///< sign of the direction from the cell to the eye along `depth`
};

Eye eye_of(const View& view) {
  const int depth = 3 - view.right - view.up;
  const bool is_cyclic = (view.right + 1) % 3 == view.up;  // right x up is then the third axis itself
  return {static_cast<std::size_t>(view.right), static_cast<std::size_t>(view.up), static_cast<std::size_t>(depth),
          is_cyclic ? 1.0 : -1.0};
}

}  // namespace

std::string cell_group(const CellMesh& cell, const View& view, const Frame& frame, int tones) {
  const Eye eye = eye_of(view);
  double nearest = -1e300, farthest = 1e300;
  for (const Point3& vertex : cell.vertices_um) {
    nearest = std::max(nearest, eye.towards * vertex[eye.depth]);
    farthest = std::min(farthest, eye.towards * vertex[eye.depth]);
  }
  const double thickness = std::max(nearest - farthest, 1e-9);
  std::vector<Facet> facets;
  for (const std::array<int, 3>& t : cell.triangles) {
    std::array<Point3, 3> p{};  // right, up, towards the eye
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& vertex = cell.vertices_um[static_cast<std::size_t>(t[k])];
      p[k] = {vertex[eye.right], vertex[eye.up], eye.towards * vertex[eye.depth]};
    }
    const Point3 a = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
    const Point3 b = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
    const Point3 n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0) || n[2] <= 0) continue;
    // Light from the upper left, in front; it reaches a little around the edge so that no part is without shape.
    const double light = std::max(0.0, (-0.35 * n[0] + 0.55 * n[1] + 0.76 * n[2]) / length);
    Facet facet;
    facet.tone = std::min(tones - 1, static_cast<int>(light * tones));
    const double depth = ((p[0][2] + p[1][2] + p[2][2]) / 3 - farthest) / thickness;
    facet.slab = std::clamp(static_cast<int>(depth * slabs), 0, slabs - 1);
    for (std::size_t k = 0; k < 3; ++k)
      facet.corners[k] = {std::lround(frame.x(p[k][0])), std::lround(frame.y(p[k][1]))};
    facets.push_back(facet);
  }
  std::stable_sort(facets.begin(), facets.end(),
                   [](const Facet& a, const Facet& b) { return a.slab != b.slab ? a.slab < b.slab : a.tone < b.tone; });
  // A line of the facet's own colour closes the seams that are seen between neighbours.
  std::string text = fmt::format("<g stroke-width=\"{:.2g}\" stroke-linejoin=\"round\">", 0.03 * frame.units_per_um);
  for (std::size_t i = 0; i < facets.size();) {
    const std::string colour = tone_colour(facets[i].tone, tones);
    const std::size_t begin = i;
    text += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"", colour);
    for (; i < facets.size() && facets[i].slab == facets[begin].slab && facets[i].tone == facets[begin].tone; ++i)
      text += path_of(facets[i]);
    text += "\"/>";
  }
  return text + "</g>\n";
}

}  // namespace rouleau::campaign
