// SPDX-License-Identifier: BSD-3-Clause
// Files on the way to their final name, such that an attempt that was frozen and taken over meanwhile cannot finish
// them.
//
// An attempt writes into files of its own: their names carry its number. It asks the fence last, then renames. A newer
// attempt removes the unfinished files of all older ones before it reads anything. So a rename that was allowed before
// the newer attempt existed either came before that removal, and the newer attempt sees its result, or it fails.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "storage/files.hpp"

namespace rouleau {

/// "<name>.a<attempt>.tmp"
[[nodiscard]] std::string unfinished_name(const std::string& name, int attempt);

/// Removes what this or an earlier attempt left unfinished in a directory.
void remove_unfinished(FileSystem& files, const std::filesystem::path& directory, int attempt);

/// Replaces `path` as a whole, like write_aside, through the attempt's own unfinished file. `fence` throws
/// Error(superseded) if a newer attempt exists.
void write_fenced(FileSystem& files, const std::filesystem::path& path, std::string_view bytes, int attempt,
                  const std::function<void()>& fence);
/// Same, with what `fill` writes.
void write_fenced(FileSystem& files, const std::filesystem::path& path, const std::function<void(File&)>& fill,
                  int attempt, const std::function<void()>& fence);

}  // namespace rouleau
