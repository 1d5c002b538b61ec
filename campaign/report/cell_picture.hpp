// SPDX-License-Identifier: BSD-3-Clause
// Cells as SVG: triangles from far to near, lit from above, no other program needed.
#pragma once

#include <string>

#include "report/cell_shape.hpp"

namespace rouleau::campaign {

/// From where a cell is looked at: which axis goes to the right and which up.
struct View {
  int right = 0, up = 2;
};

inline constexpr View side_view{0, 2};   ///< along +y, the flow goes to the right
inline constexpr View front_view{1, 2};  ///< along -x, the flow comes towards the eye

/// Places a view's plane on the paper: `origin` (µm) lies at (left, bottom) in units of the SVG.
struct Frame {
  double units_per_um = 10;
  double origin_right_um = 0, origin_up_um = 0;
  double left = 0, bottom = 0;

  [[nodiscard]] double x(double right_um) const { return left + units_per_um * (right_um - origin_right_um); }
  [[nodiscard]] double y(double up_um) const { return bottom - units_per_um * (up_um - origin_up_um); }
};

/// A <g> of the triangles that face the eye, whole units, from far to near in slabs; of one of `tones` (at least 2) in
/// one path.
[[nodiscard]] std::string cell_group(const CellMesh& cell, const View& view, const Frame& frame, int tones);

}  // namespace rouleau::campaign
