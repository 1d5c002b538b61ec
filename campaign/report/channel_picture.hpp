// SPDX-License-Identifier: BSD-3-Clause
// One large picture: the cells in their channel from the side and from the front.
#pragma once

#include <string>

#include "report/cell_shape.hpp"

namespace rouleau::campaign {

/// Walls, axis, direction of the flow, a scale bar, and a caption of `name`, time and displacement of the first cell.
/// Of a channel longer than three times its width, the part around the first cell. A complete SVG file.
[[nodiscard]] std::string channel_picture(const Shape& shape, const std::string& name);

}  // namespace rouleau::campaign
