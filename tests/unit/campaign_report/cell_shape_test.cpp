// SPDX-License-Identifier: BSD-3-Clause
// Cells as `rouleau-solver shape` prints them: reading, geometry, pictures.
#include "report/cell_shape.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "report/cell_picture.hpp"
#include "report/cell_tiles.hpp"
#include "report/channel_picture.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A box of 20 x 12 x 10 µm that holds an octahedron of radius 2 about `centre`; with flags of a 4 x 3 plane.
std::string octahedron(Point3 centre, double period = 0) {
  std::string vertices;
  for (int v = 0; v < 6; ++v) {
    Point3 p = centre;
    p[static_cast<std::size_t>(v / 2)] += v % 2 == 0 ? 2 : -2;
    if (period > 0) p[0] -= period * std::floor(p[0] / period);
    vertices += fmt::format("{}[{},{},{}]", v == 0 ? "" : ",", p[0], p[1], p[2]);
  }
  return R"({"contract":1,"step":40,"time_s":0.25,"box_um":[20,12,10],"node_spacing_um":0.5,"cells":[{"vertices_um":[)" +
         vertices +
         R"(],"triangles":[[0,2,4],[2,1,4],[1,3,4],[3,0,4],[2,0,5],[1,2,5],[3,1,5],[0,3,5]]}],"slice":{"normal":"y",)"
         R"("at_um":6,"first_node_um":2.5,"spacing_um":5,"columns":"x","rows":"z","inside":["0000","0110"]}})";
}

Shape parsed(const std::string& json) { return parse_shape(json, "test"); }

void expect_near(const Point3& found, const Point3& expected) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-12) << k;  // rounding of 24 sums
}

TEST(CellShape, CentreIsThatOfTheVolume) {
  const Shape shape = parsed(octahedron({7, 6.3, 5.4}));
  expect_near(centre_of(shape.cells[0]), {7, 6.3, 5.4});
  EXPECT_NEAR(displacement_um(shape, shape.cells[0]), 0.5, 1e-12);
  // A tetrahedron's centre of volume is the mean of its corners, wherever further vertices lie that no triangle names.
  CellMesh tetrahedron{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 0, 0.1}},
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  expect_near(centre_of(tetrahedron), {1, 1, 1});
}

TEST(CellShape, IsWholeAcrossTheSeam) {
  const Shape shape = parsed(octahedron({19.5, 6, 5}, 20));
  expect_near(centre_of(shape.cells[0]), {19.5, 6, 5});
  for (const Point3& vertex : shape.cells[0].vertices_um) EXPECT_LE(std::abs(vertex[0] - 19.5), 2 + 1e-12);
}

TEST(CellShape, CutIsTheOutlineInThePlane) {
  const Shape shape = parsed(octahedron({7, 6, 5}));
  double length = 0;
  for (const auto& [a, b] : cut(shape.cells[0], 1, 7.0)) {
    EXPECT_NEAR(a[1], 7, 1e-12);
    length += std::hypot(a[0] - b[0], a[2] - b[2]);
  }
  EXPECT_NEAR(length, 4 * std::sqrt(2.0), 1e-12);  // half-way out, a square with half the diagonal
  EXPECT_TRUE(cut(shape.cells[0], 1, 9.0).empty());
}

TEST(CellShape, CoarseningMergesWhatIsNear) {
  CellMesh mesh = parsed(octahedron({7, 6, 5})).cells[0];
  EXPECT_EQ(coarsened(mesh, 0.1).triangles.size(), 8U);
  EXPECT_TRUE(coarsened(mesh, 1000).triangles.empty());
  mesh.vertices_um.push_back({7, 6, 7.01});  // beside the upper tip
  mesh.triangles.push_back({0, 2, 6});
  EXPECT_EQ(coarsened(mesh, 0.5).vertices_um.size(), 6U);
}

TEST(CellShape, RefusesWhatItCannotDraw) {
  const std::string good = octahedron({7, 6, 5});
  const auto refuses = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_THROW(static_cast<void>(parsed(bad)), Error) << to;
  };
  refuses("[0,2,4]", "[0,2,6]");
  refuses("[0,2,4]", "[0,2,-1]");
  refuses("[0,2,4]", "[0,2]");
  refuses("[20,12,10]", "[20,0,10]");
  refuses("\"y\"", "\"x\"");
  refuses("0110", "01x0");
  refuses("0110", "011");
  refuses("\"spacing_um\":5", "\"spacing_um\":0");
  refuses("\"time_s\":0.25", "\"time_s\":\"soon\"");
  EXPECT_THROW(static_cast<void>(parsed("")), Error);
  EXPECT_THROW(static_cast<void>(parsed(R"({"step":1,"time_s":0,"box_um":[1,1,1],"cells":[]})")), Error);
}

TEST(CellPicture, ShowsOnlyWhatFacesTheEye) {
  const CellMesh cell = parsed(octahedron({7, 6, 5})).cells[0];
  for (const View& view : {side_view, front_view}) {
    const std::string group = cell_group(cell, view, Frame{}, 10);
    EXPECT_EQ(static_cast<int>(std::count(group.begin(), group.end(), 'M')), 4);  // of eight faces
  }
  CellMesh inside_out = cell;
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  // The far side now, as from within: other faces than before.
  EXPECT_NE(cell_group(inside_out, side_view, Frame{}, 10), cell_group(cell, side_view, Frame{}, 10));
}

TEST(CellPicture, SideViewLooksAlongY) {
  // One triangle that looks towards -y: seen from the side; its mirror image is not.
  CellMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  EXPECT_THAT(cell_group(sheet, side_view, Frame{}, 10), HasSubstr("M0 0l10 0 -10 -10z"));
  std::swap(sheet.triangles[0][0], sheet.triangles[0][1]);
  EXPECT_THAT(cell_group(sheet, side_view, Frame{}, 10), Not(HasSubstr("M")));
}

TEST(CellPicture, NearPartsArePaintedLast) {
  // Two parallel sheets that face the eye at -y; the one at smaller y is nearer.
  const CellMesh sheets{{{0, 5, 0}, {1, 5, 0}, {0, 5, 1}, {2, 1, 0}, {3, 1, 0}, {2, 1, 1}}, {{3, 4, 5}, {0, 1, 2}}};
  const std::string group = cell_group(sheets, side_view, Frame{}, 10);
  EXPECT_LT(group.find("M0 0"), group.find("M20 0"));
}

TEST(CellPicture, TilesSayWhatTheyShow) {
  const Shape shape = parsed(octahedron({7, 6.3, 5.4}));
  EXPECT_THAT(shape_tile(shape, window_um(shape), "a").body, HasSubstr("0.25 s, d 0.50 µm"));
  const std::string slice = slice_tile(shape, 10).body;
  EXPECT_THAT(slice, HasSubstr("slice at y = 6.00 µm"));
  const std::string film = film_strip({shape, shape}, "<b>");
  EXPECT_THAT(film, ::testing::AllOf(HasSubstr("&lt;b&gt;"), Not(HasSubstr("<b>")), HasSubstr("</svg>")));
}

TEST(CellPicture, ChannelHasWallsScaleAndCaption) {
  const std::string picture = channel_picture(parsed(octahedron({19.5, 6.3, 5.4}, 20)), "#3, λ = 5");
  EXPECT_THAT(picture, ::testing::AllOf(HasSubstr("#3, λ = 5, t = 0.25 s, d = 0.50 µm"), HasSubstr("5 µm"),
                                        HasSubstr("flow"), HasSubstr("xmlns=")));
  // The cell lies on the seam: it is drawn at both ends, once in the front view.
  std::size_t groups = 0;
  for (std::size_t at = 0; (at = picture.find("<g stroke-width", at)) != std::string::npos; ++at) ++groups;
  EXPECT_EQ(groups, 3U);
}

}  // namespace
}  // namespace rouleau::campaign
