// SPDX-License-Identifier: BSD-3-Clause
// The files in a checkpoint directory: their names, their order, and which may go.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "storage/files.hpp"

namespace rouleau {

/// The step of a generation's file name ("000000012000.h5"); no value for any other name.
[[nodiscard]] std::optional<std::int64_t> step_of_checkpoint(const std::string& name);

/// The generations that are not needed once generation `step` is in place: all but the newest `keep` up to it, and
/// every later one. A later one exists only if the resume that led here rejected it. To be asked before the fence, so
/// that the answer never holds a successor's generation.
[[nodiscard]] std::vector<std::filesystem::path> superfluous_generations(FileSystem& files,
                                                                         const std::filesystem::path& directory,
                                                                         std::int64_t step, int keep);

}  // namespace rouleau
