// SPDX-License-Identifier: BSD-3-Clause
// How a user names points: a key, the beginning of one, #ordinal, or parameter=value.
#pragma once

#include <string>
#include <vector>

#include "store/store.hpp"

namespace rouleau::campaign {

/// The points that `word` names, by ordinal: a key or the beginning of exactly one; `#3`; or `lambda=5` and
/// `lambda=5,replica=2` for all points with those values (names as in report/columns.hpp, numbers compared as numbers).
/// throws  Error (not_found) when there is none, (usage) when a beginning fits several or a name is unknown
std::vector<PointRow> find_points(const Store& store, const std::string& word);

}  // namespace rouleau::campaign
