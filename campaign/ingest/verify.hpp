// SPDX-License-Identifier: BSD-3-Clause
// Database against run directories: everything is read and computed again, and compared.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "store/store.hpp"

namespace rouleau::campaign {

/// Something that is not as it should be.
struct Finding {
  std::string key;      ///< of the point; empty: of the campaign
  std::string file;     ///< relative to the campaign's directory
  bool damage = true;   ///< false: only not read yet, or not known; `rouleau sync` or `rebuild` puts it right
  std::string problem;  ///< what, where, and what to do
};

/// SQLite's own checks, foreign keys, study.ini against the study in it, and point folders that the database does not
/// know.
std::vector<Finding> verify_database(const Store& reader, const std::filesystem::path& campaign_directory);

/// One point: point.json against the parameters; every line of samples.csv against its check and against the samples;
/// the results against their recomputation, bit by bit; exit.json of each attempt; result.json of a finished point.
std::vector<Finding> verify_point(const Store& reader, const std::filesystem::path& campaign_directory,
                                  const std::string& key);

}  // namespace rouleau::campaign
