// SPDX-License-Identifier: BSD-3-Clause
// result.json: what a finished point came to, in its own directory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "store/store.hpp"

namespace rouleau::campaign {

/// The content of result.json from the stored rows: for each cell the window, means, error bars and class; the cost
/// over all attempts; the provenance (parameters that were swept, versions, hosts).
std::string result_json(const Store& store, std::string_view key);

/// Writes points/<key>/result.json (aside, synced, renamed) unless it says the same already. Call it once the point is
/// done, after ingest_point. throws Error when the file cannot be written
void write_result_file(const Store& store, const std::filesystem::path& campaign_directory, std::string_view key);

}  // namespace rouleau::campaign
