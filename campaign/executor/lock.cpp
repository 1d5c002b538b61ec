// SPDX-License-Identifier: BSD-3-Clause
// flock on DIR/.lock.
#include "executor/lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "executor/process.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

// A child between fork and exec shares the lock for a moment after its parent died; waiting that out costs nothing.
constexpr auto patience = std::chrono::milliseconds(500);
constexpr auto pause = std::chrono::milliseconds(20);

bool try_lock(int fd) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) return false;
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(pause);
  }
}

std::string content_of(int fd) {
  char buffer[512];
  const ssize_t got = ::pread(fd, buffer, sizeof buffer, 0);
  std::string text(buffer, static_cast<std::size_t>(got > 0 ? got : 0));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "another process" : text;
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& directory, const std::string& verb) {
  const std::filesystem::path file = directory / ".lock";
  fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (fd_ < 0) {
    fail(Exit::failed, "{}: cannot open the lock: {}. Check the directory's permissions and the disk's free space.",
         file.string(), std::strerror(errno));
  }
  if (!try_lock(fd_)) {
    const std::string holder = content_of(fd_);
    ::close(fd_);
    fail(Exit::locked, "{}: is held by {}. Wait for it, or stop it with Ctrl-C; nothing needs to be removed.",
         file.string(), holder);
  }
  const std::string text =
      fmt::format("`rouleau {}` (process {} on {})\n", verb, static_cast<long>(::getpid()), host_name());
  if (::ftruncate(fd_, 0) != 0 || ::pwrite(fd_, text.data(), text.size(), 0) < 0) {
    const int reason = errno;
    ::close(fd_);
    fail(Exit::failed, "{}: cannot write: {}. Check the disk's free space.", file.string(), std::strerror(reason));
  }
}

CampaignLock::~CampaignLock() { ::close(fd_); }

}  // namespace rouleau::campaign
