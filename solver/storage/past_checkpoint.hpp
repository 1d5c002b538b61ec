// SPDX-License-Identifier: BSD-3-Clause
// Whether a run has had a checkpoint, by its own records: a folder of checkpoints that is not there cannot say so.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "storage/file_system.hpp"

namespace rouleau {

/// A clause that names the record (progress.json, an attempt's exit.json) which tells of a checkpoint, or which is
/// damaged and might; nothing if there is none. Throws Error(io).
[[nodiscard]] std::optional<std::string> past_checkpoint(FileSystem& files, const std::filesystem::path& run_directory);

}  // namespace rouleau
