// SPDX-License-Identifier: BSD-3-Clause
// Names, removal and fenced renames of unfinished files.
#include "storage/unfinished.hpp"

#include <charconv>
#include <optional>

#include "base/error.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

/// The attempt that wrote an unfinished file; no value for any other name.
std::optional<int> attempt_of(const std::string& name) {
  const std::size_t begin = name.rfind(".a");
  if (begin == std::string::npos || !name.ends_with(".tmp")) return {};
  int attempt = 0;
  const char* first = name.data() + begin + 2;
  const char* last = name.data() + name.size() - 4;
  const auto result = std::from_chars(first, last, attempt);
  if (result.ec != std::errc{} || result.ptr != last) return {};
  return attempt;
}

}  // namespace

std::string unfinished_name(const std::string& name, int attempt) { return fmt::format("{}.a{}.tmp", name, attempt); }

void remove_unfinished(FileSystem& files, const fs::path& directory, int attempt) {
  for (const std::string& name : list_directory(files, directory)) {
    const std::optional<int> writer = attempt_of(name);
    if (writer && *writer <= attempt) remove_file(files, directory / name);
  }
}

void write_fenced(FileSystem& files, const fs::path& path, std::string_view bytes, int attempt,
                  const std::function<void()>& fence) {
  write_fenced(
      files, path, [bytes](File& file) { file.write(bytes); }, attempt, fence);
}

void write_fenced(FileSystem& files, const fs::path& path, const std::function<void(File&)>& fill, int attempt,
                  const std::function<void()>& fence) {
  const fs::path unfinished = path.parent_path() / unfinished_name(path.filename().string(), attempt);
  try {
    File file = File::overwrite(files, unfinished);
    fill(file);
    file.sync();
    file.close();
    fence();
    rename_synced(files, unfinished, path);
  } catch (const Error&) {
    files.unlink(unfinished.string());  // if it is still there
    throw;
  }
}

}  // namespace rouleau
