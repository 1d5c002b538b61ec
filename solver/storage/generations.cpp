// SPDX-License-Identifier: BSD-3-Clause
// Names and pruning of checkpoint generations.
#include "storage/generations.hpp"

#include <charconv>

#include "base/error.hpp"
#include "storage/checkpoint.hpp"
#include "storage/resume.hpp"

namespace rouleau {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t step_digits = 12;

/// The attempt that wrote an unfinished file; no value for any other name.
std::optional<int> attempt_of_unfinished(const std::string& name) {
  const std::size_t begin = name.find(".h5.a");
  if (begin == std::string::npos || !name.ends_with(".tmp")) return {};
  int attempt = 0;
  const char* first = name.data() + begin + 5;
  const char* last = name.data() + name.size() - 4;
  const auto result = std::from_chars(first, last, attempt);
  if (result.ec != std::errc{} || result.ptr != last) return {};
  return attempt;
}

}  // namespace

std::string checkpoint_name(std::int64_t step) { return fmt::format("{:012}.h5", step); }

std::optional<std::int64_t> step_of_checkpoint(const std::string& name) {
  std::int64_t step = 0;
  const auto result = std::from_chars(name.data(), name.data() + name.size(), step);
  if (result.ec != std::errc{} || step < 0 || name.size() < step_digits + 3 || name != checkpoint_name(step)) return {};
  return step;
}

std::string unfinished_name(std::int64_t step, int attempt) {
  return fmt::format("{}.a{}.tmp", checkpoint_name(step), attempt);
}

void remove_unfinished(FileSystem& files, const fs::path& directory, int attempt) {
  for (const std::string& name : list_directory(files, directory)) {
    const std::optional<int> writer = attempt_of_unfinished(name);
    if (writer && *writer <= attempt) remove_file(files, directory / name);
  }
}

void remove_old_generations(FileSystem& files, const fs::path& directory, std::int64_t step, int keep) {
  int kept = 0;
  for (const fs::path& file : find_checkpoints(files, directory)) {
    const std::int64_t generation = step_of_checkpoint(file.filename().string()).value();
    if (generation <= step && kept < keep) {
      ++kept;
    } else {
      remove_file(files, file);
    }
  }
  sync_directory(files, directory);
}

}  // namespace rouleau
