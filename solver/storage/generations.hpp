// SPDX-License-Identifier: BSD-3-Clause
// The files in a checkpoint directory: their names, their order, and which may go.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "storage/files.hpp"

namespace rouleau {

/// The step of a generation's file name ("000000012000.h5"); no value for any other name.
[[nodiscard]] std::optional<std::int64_t> step_of_checkpoint(const std::string& name);

/// The name under which an attempt writes a generation before it is whole. The attempt's number keeps a superseded
/// solver from writing into its successor's file.
[[nodiscard]] std::string unfinished_name(std::int64_t step, int attempt);

/// Removes what crashed writers of this or an earlier attempt left unfinished.
void remove_unfinished(FileSystem& files, const std::filesystem::path& directory, int attempt);

/// After generation `step` is in place: removes all but the newest `keep` up to it, and every later one. A later one
/// exists only if the resume that led here rejected it.
void remove_old_generations(FileSystem& files, const std::filesystem::path& directory, std::int64_t step, int keep);

}  // namespace rouleau
