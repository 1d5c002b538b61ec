// SPDX-License-Identifier: BSD-3-Clause
// A file system with one file, in memory, and the seal of a checkpoint made anew on it.
#pragma once

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "storage/checksum.hpp"
#include "storage/file_system.hpp"
#include "storage/seal.hpp"

namespace rouleau::testing {

/// Whatever path is opened is the one file, but `<name>.tmp`: that one can take its place.
class MemoryFile final : public FileSystem {
 public:
  explicit MemoryFile(std::string bytes = {}) : content(std::move(bytes)) {}
  std::string content;

  int open(const std::string& path, int flags, unsigned) override {
    const int file = path.ends_with(".tmp") ? unfinished : descriptor;
    if ((flags & O_TRUNC) != 0) of(file).clear();
    return file;
  }
  ssize_t write(int file, const void* bytes, std::size_t count) override {
    return pwrite(file, bytes, count, of(file).size());
  }
  ssize_t pwrite(int file, const void* bytes, std::size_t count, std::uint64_t offset) override {
    std::string& all = of(file);
    all.resize(std::max<std::size_t>(all.size(), offset + count));
    std::memcpy(all.data() + offset, bytes, count);
    return static_cast<ssize_t>(count);
  }
  ssize_t pread(int file, void* bytes, std::size_t count, std::uint64_t offset) override {
    if (offset >= of(file).size()) return 0;
    return static_cast<ssize_t>(of(file).copy(static_cast<char*>(bytes), count, offset));
  }
  int truncate(int file, std::uint64_t length) override {
    of(file).resize(length);
    return 0;
  }
  int allocate(int file, std::uint64_t length) override {
    of(file).resize(std::max<std::size_t>(of(file).size(), length));
    return 0;
  }
  int fsync(int) override { return 0; }
  int close(int) override { return 0; }
  int rename(const std::string& from, const std::string& to) override {
    if (!from.ends_with(".tmp") || to.ends_with(".tmp")) return refused();
    content = std::exchange(aside_, {});
    return 0;
  }
  int unlink(const std::string&) override { return refused(); }
  int mkdir(const std::string&, unsigned) override { return refused(); }
  int size(const std::string&, std::uint64_t& bytes) override {
    bytes = content.size();
    return 0;
  }
  int list(const std::string&, std::vector<std::string>& names) override {
    names.clear();
    return 0;
  }
  int free_space(const std::string&, std::uint64_t& bytes) override {
    bytes = std::uint64_t{1} << 40U;
    return 0;
  }

 private:
  static constexpr int descriptor = 1000, unfinished = 1001;  // belong to nobody
  std::string& of(int file) { return file == unfinished ? aside_ : content; }
  std::string aside_;
  static int refused() {
    errno = EROFS;
    return -1;
  }
};

/// What write_seal does, without MPI: the bytes behind the seal pass for those that were sealed.
inline void reseal(MemoryFile& file) {
  const std::uint64_t sum = seal_part(file, "", file.content.size(), {});
  std::string text = fmt::format("rouleau checkpoint\nbytes {}\nseal {}\n", file.content.size(), hex(sum));
  text.resize(seal_bytes, '\0');
  file.content.replace(0, seal_bytes, text);
}

}  // namespace rouleau::testing
