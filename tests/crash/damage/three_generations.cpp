// SPDX-License-Identifier: BSD-3-Clause
#include "crash/damage/three_generations.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "storage/inspect.hpp"

namespace rouleau::testing {

namespace fs = std::filesystem;

ThreeGenerations::ThreeGenerations() {
  for (const int end : steps) {
    run.set_steps(end);
    run.finish();
  }
  sound_ = files();
  for (int generation = 0; generation < 3; ++generation) {
    const CheckpointReport report = inspect_checkpoint(posix_file_system(), run.path(checkpoint(generation)));
    counted_.push_back(report.metadata.samples.bytes);
  }
  digest_ = digest(checkpoint(2));
}

std::string ThreeGenerations::checkpoint(int generation) {
  return fmt::format("checkpoints/{:012}.h5", steps[generation]);
}

void ThreeGenerations::put_back() const {
  for (const char* folder : {"attempts", "checkpoints"}) fs::remove_all(run.path(folder));
  fs::create_directory(run.path("checkpoints"));
  for (const auto& [name, bytes] : sound_) set_content(run.path(name), bytes);
}

bool ThreeGenerations::has_the_same_end() const {
  return run.samples() == sound("samples.csv") && digest(checkpoint(2)) == digest_;
}

bool ThreeGenerations::is_untouched() const { return files() == sound_; }

std::map<std::string, std::string> ThreeGenerations::files() const {
  std::map<std::string, std::string> all{{"samples.csv", run.samples()}};
  for (const auto& entry : fs::directory_iterator(run.path("checkpoints")))
    all["checkpoints/" + entry.path().filename().string()] = content_of(entry.path());
  return all;
}

std::string ThreeGenerations::digest(const std::string& checkpoint) const {
  try {
    return inspect_checkpoint(posix_file_system(), run.path(checkpoint)).digest;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace rouleau::testing
