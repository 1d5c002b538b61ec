// SPDX-License-Identifier: BSD-3-Clause
// The POSIX implementation of the file-system seam.
#include "storage/file_system.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace rouleau {
namespace {

class PosixFileSystem final : public FileSystem {
 public:
  int open(const std::string& path, int flags, unsigned mode) override {
    return ::open(path.c_str(), flags | O_CLOEXEC, mode);
  }
  ssize_t write(int file, const void* bytes, std::size_t count) override { return ::write(file, bytes, count); }
  ssize_t pwrite(int file, const void* bytes, std::size_t count, std::uint64_t offset) override {
    return ::pwrite(file, bytes, count, static_cast<off_t>(offset));
  }
  ssize_t pread(int file, void* bytes, std::size_t count, std::uint64_t offset) override {
    return ::pread(file, bytes, count, static_cast<off_t>(offset));
  }
  int truncate(int file, std::uint64_t length) override { return ::ftruncate(file, static_cast<off_t>(length)); }
  int allocate(int file, std::uint64_t length) override {
    const int error = ::posix_fallocate(file, 0, static_cast<off_t>(length));
    if (error == 0) return 0;
    errno = error;
    return -1;
  }
  int fsync(int file) override { return ::fsync(file); }
  int close(int file) override { return ::close(file); }
  int rename(const std::string& from, const std::string& to) override { return std::rename(from.c_str(), to.c_str()); }
  int unlink(const std::string& path) override { return ::unlink(path.c_str()); }
  int mkdir(const std::string& path, unsigned mode) override { return ::mkdir(path.c_str(), mode); }

  int size(const std::string& path, std::uint64_t& bytes) override {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return -1;
    if (!S_ISREG(status.st_mode)) {
      errno = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
      return -1;
    }
    bytes = static_cast<std::uint64_t>(status.st_size);
    return 0;
  }

  int list(const std::string& directory, std::vector<std::string>& names) override {
    names.clear();
    DIR* stream = ::opendir(directory.c_str());
    if (stream == nullptr) return -1;
    errno = 0;
    while (const dirent* entry = ::readdir(stream)) {
      const std::string name = entry->d_name;
      if (name != "." && name != "..") names.push_back(name);
      errno = 0;
    }
    const int error = errno;
    ::closedir(stream);
    errno = error;
    return error == 0 ? 0 : -1;
  }

  int free_space(const std::string& directory, std::uint64_t& bytes) override {
    struct statvfs status {};
    if (::statvfs(directory.c_str(), &status) != 0) return -1;
    bytes = static_cast<std::uint64_t>(status.f_bavail) * status.f_frsize;
    return 0;
  }
};

}  // namespace

FileSystem& posix_file_system() {
  static PosixFileSystem system;
  return system;
}

}  // namespace rouleau
