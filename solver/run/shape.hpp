// SPDX-License-Identifier: BSD-3-Clause
// The verb `shape`: the cells of a checkpoint or of a snapshot as text, for programs that draw them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "storage/file_system.hpp"

namespace rouleau {

/// The JSON object of share/contract.md section 13. `slice_normal` 1 (y) or 2 (z) adds the inside flags of the nodes
/// nearest to the plane through the first cell's centre.
/// throws Error(bad_input) if the file is damaged, has no cells, or is a snapshot and flags are wanted; Error(io)
std::string shape_text(const std::filesystem::path& file, std::optional<int> slice_normal, FileSystem& files);

}  // namespace rouleau
