// SPDX-License-Identifier: BSD-3-Clause
// The seam to the operating system: every file-system call that the persistent files of a run need.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rouleau {

/// The calls as the operating system has them: -1 and errno on failure. What they mean for a run is decided in
/// files.hpp. A test puts its own in place, to fail or to "die" at any call.
class FileSystem {
 public:
  virtual ~FileSystem() = default;

  virtual int open(const std::string& path, int flags, unsigned mode) = 0;
  virtual ssize_t write(int file, const void* bytes, std::size_t count) = 0;
  virtual ssize_t pwrite(int file, const void* bytes, std::size_t count, std::uint64_t offset) = 0;
  virtual ssize_t pread(int file, void* bytes, std::size_t count, std::uint64_t offset) = 0;
  virtual int truncate(int file, std::uint64_t length) = 0;
  virtual int allocate(int file, std::uint64_t length) = 0;  ///< reserves the blocks of [0, length)
  virtual int fsync(int file) = 0;
  virtual int close(int file) = 0;
  virtual int rename(const std::string& from, const std::string& to) = 0;
  virtual int unlink(const std::string& path) = 0;
  virtual int mkdir(const std::string& path, unsigned mode) = 0;
  virtual int size(const std::string& path, std::uint64_t& bytes) = 0;                  ///< of a regular file
  virtual int list(const std::string& directory, std::vector<std::string>& names) = 0;  ///< without "." and ".."
  virtual int free_space(const std::string& directory, std::uint64_t& bytes) = 0;       ///< for an ordinary user
};

/// The real one.
[[nodiscard]] FileSystem& posix_file_system();

}  // namespace rouleau
