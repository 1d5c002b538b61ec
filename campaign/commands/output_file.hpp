// SPDX-License-Identifier: BSD-3-Clause
// A file that a verb writes because the user named it: whole or not at all, and nothing of the user's is lost for it.
#pragma once

#include <filesystem>
#include <functional>

namespace rouleau::campaign {

/// Has `write` make the file under another name beside `file`, syncs it and puts it in its place; when `write` fails,
/// removes it.
/// throws  Error (usage) if `file` exists and may not be overwritten, is no regular file or is a campaign's database
void write_output_file(const std::filesystem::path& file, bool may_overwrite,
                       const std::function<void(const std::filesystem::path& aside)>& write);

}  // namespace rouleau::campaign
