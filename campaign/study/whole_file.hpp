// SPDX-License-Identifier: BSD-3-Clause
// Small files that exist whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rouleau::campaign {

/// No JSON record of a run directory comes near this many bytes.
inline constexpr std::size_t largest_record = std::size_t{1} << 24;

/// Writes `text` aside, syncs, renames over `file`, syncs the directory.   throws Error (failed) naming the file and
/// the reason
void write_whole_file(const std::filesystem::path& file, std::string_view text);

/// Has `write` make the file under another name beside `file`; syncs it, renames it over `file`, syncs the directory.
/// When any of this fails, and when a killed one has left something there, nothing stays beside.
/// throws Error (failed) naming the file and the reason, and what `write` throws
void make_whole_file(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path& aside)>& write);

/// The whole content, or nothing if there is no such file.
/// throws Error (failed) if it exists but cannot be read, or has more than `most_bytes`
[[nodiscard]] std::optional<std::string> read_whole_file(const std::filesystem::path& file,
                                                         std::size_t most_bytes = SIZE_MAX);

/// Makes a directory and those above it that are missing; each of them survives a power failure.
void make_directories(const std::filesystem::path& directory);

/// Syncs a directory, so that files made in it survive a power failure.
void sync_directory(const std::filesystem::path& directory);

/// XXH64 (seed 0) as 16 lower-case hex digits.
[[nodiscard]] std::string digest_of(std::string_view bytes);

/// "CRC SIZE", as the program `cksum` of POSIX says it: what a shell can compute everywhere.
[[nodiscard]] std::string cksum_of(std::string_view bytes);

}  // namespace rouleau::campaign
