// SPDX-License-Identifier: BSD-3-Clause
// A campaign's database as a file of its own, to be taken elsewhere.
#pragma once

#include <filesystem>
#include <span>

#include "store/store.hpp"

namespace rouleau::campaign {

/// Makes `file`, a database of the same tables and views with these points (ordinals): parameters, attempts, samples,
/// results and events, the study's text and the analysis. Left out is what only the campaign itself can use: tokens and
/// processes of attempts, times of retries, engines.
/// A point is read in one piece and nothing is locked in between: a writer of the campaign waits for one point at most.
/// The file is not synced.   throws Error, and leaves a part of it, when it cannot be written
Store copy_points(const Store& from, const std::filesystem::path& file, std::span<const std::int64_t> ordinals);

}  // namespace rouleau::campaign
