// SPDX-License-Identifier: BSD-3-Clause
// Writing what a study makes of a campaign: directories first, then the database, so that a kill leaves nothing to
// repair.
#pragma once

#include <filesystem>
#include <vector>

#include "study/expand.hpp"
#include "study/merge.hpp"

namespace rouleau::campaign {

/// The points of a campaign by their point.json, in the order of ordinals; none if there is no database yet.
/// A damaged point.json is replaced by what the database knows, its identity by that of the candidate with the same
/// key.
[[nodiscard]] std::vector<Point> existing_points(const std::filesystem::path& directory, const Expansion& expansion);

/// Writes named files, run.ini and point.json of every point, study.ini, and the database (made if it is not there).
void write_campaign(const std::filesystem::path& directory, const Study& study, const Expansion& expansion,
                    const Merge& merge);

}  // namespace rouleau::campaign
