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

}  // namespace

std::string checkpoint_name(std::int64_t step) { return fmt::format("{:012}.h5", step); }

std::optional<std::int64_t> step_of_checkpoint(const std::string& name) {
  std::int64_t step = 0;
  const auto result = std::from_chars(name.data(), name.data() + name.size(), step);
  if (result.ec != std::errc{} || step < 0 || name.size() < step_digits + 3 || name != checkpoint_name(step)) return {};
  return step;
}

std::vector<fs::path> superfluous_generations(FileSystem& files, const fs::path& directory, std::int64_t step,
                                              int keep) {
  std::vector<fs::path> superfluous;
  int kept = 1;  // generation `step` itself, there or not
  for (const fs::path& file : find_checkpoints(files, directory)) {
    const std::int64_t generation = step_of_checkpoint(file.filename().string()).value();
    if (generation == step) continue;
    if (generation < step && kept < keep) {
      ++kept;
    } else {
      superfluous.push_back(file);
    }
  }
  return superfluous;
}

}  // namespace rouleau
