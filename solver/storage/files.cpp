// SPDX-License-Identifier: BSD-3-Clause
// File operations on top of the seam.
#include "storage/files.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace rouleau {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds longest_pause(400);  // between two attempts to read the same bytes

std::string remedy(FileSystem& files, const fs::path& path, int error, std::uint64_t needed) {
  switch (error) {
    case ENOSPC:
    case EDQUOT: {
      std::uint64_t free = 0;
      const bool known = files.free_space(path.parent_path().string(), free) == 0;
      const std::string room = known ? fmt::format(", {} bytes are free", free) : std::string();
      const std::string need = needed > 0 ? fmt::format("; {} bytes are needed", needed) : std::string();
      return fmt::format("{}{}. Free space or raise the quota, then start the run again.", need, room);
    }
    case EFBIG:
      return ". Raise the file size limit (ulimit -f), then start the run again.";
    case EMFILE:
    case ENFILE:
      return ". Raise the limit of open files (ulimit -n), then start the run again.";
    case EACCES:
    case EPERM:
    case EROFS:
      return ". Check the owner and the permissions of the directory and whether it is mounted writable.";
    case ENOENT:
    case ENOTDIR:
      return ". Check the path; the run directory may have been moved or removed.";
    default:
      return ". Check the file system, then start the run again.";
  }
}

fs::path directory_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

void fail_call(FileSystem& files, const fs::path& path, const char* call, int error, std::uint64_t needed) {
  fail(Exit::io, "{}: {} failed: {} (errno {}){}", path.string(), call, std::strerror(error), error,
       remedy(files, path, error, needed));
}

File::File(FileSystem& files, fs::path path, int flags)
    : files_(&files), path_(std::move(path)), file_(files.open(path_.string(), flags, 0666)) {
  if (file_ < 0) fail_call(*files_, path_, "open", errno);
}

File File::read(FileSystem& files, const fs::path& path) { return {files, path, O_RDONLY}; }
File File::update(FileSystem& files, const fs::path& path) { return {files, path, O_RDWR}; }
File File::append(FileSystem& files, const fs::path& path) { return {files, path, O_RDWR | O_APPEND}; }
File File::overwrite(FileSystem& files, const fs::path& path) { return {files, path, O_RDWR | O_CREAT | O_TRUNC}; }

File::~File() {
  if (file_ >= 0) files_->close(file_);
}

File::File(File&& other) noexcept
    : files_(other.files_), path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

File& File::operator=(File&& other) noexcept {
  if (this != &other) {
    if (file_ >= 0) files_->close(file_);
    files_ = other.files_;
    path_ = std::move(other.path_);
    file_ = std::exchange(other.file_, -1);
  }
  return *this;
}

void File::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = files_->write(file_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail_call(*files_, path_, "write", errno, bytes.size());
    if (done == 0) fail_call(*files_, path_, "write", ENOSPC, bytes.size());
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void File::write_at(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = files_->pwrite(file_, bytes.data(), bytes.size(), offset);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail_call(*files_, path_, "pwrite", errno, bytes.size());
    if (done == 0) fail_call(*files_, path_, "pwrite", ENOSPC, bytes.size());
    bytes.remove_prefix(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
  }
}

std::size_t File::read_at(std::uint64_t offset, void* bytes, std::size_t count, Exit lost) const {
  std::size_t have = 0;
  std::chrono::milliseconds pause(100);
  while (have < count) {
    const ssize_t done = files_->pread(file_, static_cast<char*>(bytes) + have, count - have, offset + have);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0 && errno == EIO) {  // lost for good, or a server of a network file system that was away
      if (pause > longest_pause) {
        fail(lost, "{}: the medium cannot read {} bytes at {} (errno {}). Check it, then start the run again.",
             path_.string(), count, offset, EIO);
      }
      std::this_thread::sleep_for(pause);
      pause *= 2;
      continue;
    }
    if (done < 0) fail_call(*files_, path_, "pread", errno);
    if (done == 0) break;
    have += static_cast<std::size_t>(done);
  }
  return have;
}

void File::truncate(std::uint64_t length) {
  if (files_->truncate(file_, length) != 0) fail_call(*files_, path_, "ftruncate", errno);
}

void File::allocate(std::uint64_t length) {
  int result = -1;
  do result = files_->allocate(file_, length);
  while (result != 0 && errno == EINTR);
  if (result != 0) fail_call(*files_, path_, "fallocate", errno, length);
}

void File::sync() {
  if (files_->fsync(file_) != 0) fail_call(*files_, path_, "fsync", errno);
}

void File::close() {
  // Linux frees the descriptor even when close reports an error, so it is never closed twice.
  const int file = std::exchange(file_, -1);
  if (files_->close(file) != 0 && errno != EINTR) fail_call(*files_, path_, "close", errno);
}

std::string read_file(FileSystem& files, const fs::path& path) {
  const File file = File::read(files, path);
  std::string content;
  // Files of /proc report no size, so the end is found by reading.
  for (std::size_t step = 4096;; step = std::min<std::size_t>(2 * step, 1U << 22U)) {
    const std::size_t before = content.size();
    content.resize(before + step);
    const std::size_t count = file.read_at(before, content.data() + before, step);
    content.resize(before + count);
    if (count < step) return content;
  }
}

bool read_file_if_there(FileSystem& files, const fs::path& path, std::string& content) {
  if (!exists(files, path)) return false;
  content = read_file(files, path);
  return true;
}

void read_blocks(const File& file, std::uint64_t bytes, const std::function<void(std::string_view)>& take) {
  constexpr std::uint64_t most = 1U << 20U;
  std::string block(std::min(bytes, most), '\0');
  for (std::uint64_t begin = 0; begin < bytes; begin += block.size()) {
    const std::size_t count = file.read_at(begin, block.data(), std::min<std::uint64_t>(block.size(), bytes - begin));
    take(std::string_view(block).substr(0, count));
    if (count < block.size()) return;
  }
}

std::uint64_t file_size(FileSystem& files, const fs::path& path) {
  std::uint64_t bytes = 0;
  if (files.size(path.string(), bytes) != 0) fail_call(files, path, "stat", errno);
  return bytes;
}

bool exists(FileSystem& files, const fs::path& path) {
  std::uint64_t bytes = 0;
  if (files.size(path.string(), bytes) == 0 || errno == EISDIR) return true;
  if (errno == ENOENT || errno == ENOTDIR) return false;
  fail_call(files, path, "stat", errno);
}

std::vector<std::string> list_directory(FileSystem& files, const fs::path& directory) {
  std::vector<std::string> names;
  if (files.list(directory.string(), names) != 0) {
    if (errno == ENOENT) return {};
    fail_call(files, directory, "readdir", errno);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool make_directory(FileSystem& files, const fs::path& directory) {
  if (files.mkdir(directory.string(), 0777) != 0) {
    if (errno == EEXIST) return false;
    fail_call(files, directory, "mkdir", errno);
  }
  sync_directory(files, directory_of(directory));
  return true;
}

void sync_directory(FileSystem& files, const fs::path& directory) {
  File file = File::read(files, directory);
  file.sync();
  file.close();
}

void sync_file(FileSystem& files, const fs::path& path) {
  File file = File::update(files, path);
  file.sync();
  file.close();
}

void rename_synced(FileSystem& files, const fs::path& from, const fs::path& to) {
  if (files.rename(from.string(), to.string()) != 0) fail_call(files, from, "rename", errno);
  sync_directory(files, directory_of(to));
}

void remove_file(FileSystem& files, const fs::path& path) {
  if (files.unlink(path.string()) != 0 && errno != ENOENT) fail_call(files, path, "unlink", errno);
}

void write_aside(FileSystem& files, const fs::path& path, std::string_view bytes) {
  const fs::path aside = path.string() + ".tmp";
  File file = File::overwrite(files, aside);
  file.write(bytes);
  file.sync();
  file.close();
  rename_synced(files, aside, path);
}

void require_free_space(FileSystem& files, const fs::path& directory, const char* what, std::uint64_t needed) {
  std::uint64_t free = 0;
  if (files.free_space(directory.string(), free) != 0) fail_call(files, directory, "statvfs", errno);
  if (free >= needed) return;
  fail(Exit::io, "{}: {} needs {} bytes, {} are free. Free space, then start the run again.", directory.string(), what,
       needed, free);
}

}  // namespace rouleau
