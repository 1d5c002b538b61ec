// SPDX-License-Identifier: BSD-3-Clause
// The record of all watched calls of a run, in their order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::testing {

struct RecordedCall {
  std::int64_t number = 0;  ///< from 1
  int pid = 0;
  std::string name;          ///< open, open_empty, write, pwrite, ftruncate, posix_fallocate, fsync, close, rename, ...
  std::int64_t offset = -1;  ///< of a write, -1 at the end of the file; a length; flags of an open
  std::int64_t count = 0;
  std::int64_t result = 0;
  std::string path, other;
  std::string bytes;  ///< that were written
};

[[nodiscard]] std::vector<RecordedCall> read_calls(const std::filesystem::path& log);

}  // namespace rouleau::testing
