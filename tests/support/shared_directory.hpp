// SPDX-License-Identifier: BSD-3-Clause
// A temporary directory that all ranks of a test know.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "parallel/communicator.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {

/// Rank 0 makes it and removes it, after all ranks have finished with it. Collective in both.
class SharedDirectory {
 public:
  explicit SharedDirectory(const Communicator& comm) : comm_(comm) {
    if (comm_.is_root()) own_ = std::make_unique<TemporaryDirectory>();
    std::string name = own_ ? own_->path().string() : std::string();
    comm_.broadcast(name);
    path_ = name;
  }
  ~SharedDirectory() { comm_.barrier(); }
  SharedDirectory(const SharedDirectory&) = delete;
  SharedDirectory& operator=(const SharedDirectory&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  const Communicator& comm_;
  std::unique_ptr<TemporaryDirectory> own_;
  std::filesystem::path path_;
};

}  // namespace rouleau::testing
