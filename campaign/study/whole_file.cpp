// SPDX-License-Identifier: BSD-3-Clause
// Write aside, sync, rename, sync the directory.
#include "study/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>

#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags) : fd_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void fail_with_errno(const std::filesystem::path& file, const char* what) {
  fail(Exit::failed, "{}: cannot {}: {}. Check the disk's free space and the permissions.", file.string(), what,
       std::strerror(errno));
}

/// With the journal, if it is a database's.
void remove_unfinished(const std::filesystem::path& aside) {
  std::error_code ignored;
  for (const char* ending : {"", "-journal"}) std::filesystem::remove(aside.string() + ending, ignored);
}

void put_in_place(const std::filesystem::path& aside, const std::filesystem::path& file) {
  {
    const Descriptor written(aside, O_RDONLY);
    if (written.fd() < 0) fail_with_errno(aside, "open");
    if (::fsync(written.fd()) != 0) fail_with_errno(aside, "sync");
  }
  if (::rename(aside.c_str(), file.c_str()) != 0) fail_with_errno(file, "rename into place");
  sync_directory(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path aside = file.string() + ".tmp";
  {
    const Descriptor out(aside, O_WRONLY | O_CREAT | O_TRUNC);
    if (out.fd() < 0) fail_with_errno(aside, "create");
    while (!text.empty()) {
      const ssize_t written = ::write(out.fd(), text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_with_errno(aside, "write");
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(out.fd()) != 0) fail_with_errno(aside, "sync");
  }
  if (::rename(aside.c_str(), file.c_str()) != 0) fail_with_errno(file, "rename into place");
  sync_directory(file.has_parent_path() ? file.parent_path() : ".");
}

void make_whole_file(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path& aside)>& write) {
  const std::filesystem::path aside = file.string() + ".tmp";
  remove_unfinished(aside);
  try {
    write(aside);
    put_in_place(aside, file);
  } catch (...) {
    remove_unfinished(aside);
    throw;
  }
}

std::optional<std::string> read_whole_file(const std::filesystem::path& file, std::size_t most_bytes) {
  // A pipe in the file's place that nobody writes to would block the opening for ever; so it reads as empty.
  const Descriptor in(file, O_RDONLY | O_NONBLOCK);
  if (in.fd() < 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    fail_with_errno(file, "open");
  }
  if (::fcntl(in.fd(), F_SETFL, O_RDONLY) != 0) fail_with_errno(file, "open");
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t got = ::read(in.fd(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with_errno(file, "read");
    if (got == 0) return text;
    text.append(buffer, static_cast<std::size_t>(got));
    if (text.size() > most_bytes)
      fail(Exit::failed, "{}: has more than the {} bytes that such a file may have. Is it the right one?",
           file.string(), most_bytes);
  }
}

void make_directories(const std::filesystem::path& directory) {
  if (std::filesystem::is_directory(directory)) return;
  const std::filesystem::path above = directory.has_parent_path() ? directory.parent_path() : ".";
  make_directories(above);
  // Made by somebody else in this moment: that one syncs it.
  if (::mkdir(directory.c_str(), 0777) != 0 && errno != EEXIST) fail_with_errno(directory, "make the directory");
  sync_directory(above);
}

void sync_directory(const std::filesystem::path& directory) {
  const Descriptor folder(directory, O_RDONLY | O_DIRECTORY);
  if (folder.fd() < 0) fail_with_errno(directory, "open");
  // Some network file systems cannot sync a directory and say EINVAL: nothing more can be done there.
  if (::fsync(folder.fd()) != 0 && errno != EINVAL) fail_with_errno(directory, "sync");
}

std::string digest_of(std::string_view bytes) { return fmt::format("{:016x}", XXH64(bytes.data(), bytes.size(), 0)); }

std::string cksum_of(std::string_view bytes) {
  constexpr std::uint32_t polynomial = 0x04C11DB7;
  std::uint32_t crc = 0;
  const auto add = [&](std::uint32_t byte) {
    crc ^= byte << 24U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1U) ^ ((crc >> 31U) * polynomial);
  };
  for (const char byte : bytes) add(static_cast<unsigned char>(byte));
  // The length follows, without its leading zeros.
  for (std::size_t length = bytes.size(); length != 0; length >>= 8U) add(length & 0xFFU);
  return fmt::format("{} {}", ~crc, bytes.size());
}

}  // namespace rouleau::campaign
