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
constexpr auto shortest_patience = std::chrono::milliseconds(500);
constexpr auto pause = std::chrono::milliseconds(20);

bool try_lock(int fd, std::chrono::milliseconds patience) {
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

/// Whether the lock came free in time. A holder that is no `sync` will not end soon.
bool wait_for_lock(int fd, LockPatience patience) {
  if (try_lock(fd, shortest_patience)) return true;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience.seconds);
  while (std::chrono::steady_clock::now() < deadline && content_of(fd).find("`rouleau run`") == std::string::npos) {
    if (try_lock(fd, shortest_patience)) return true;
  }
  return false;
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& directory, const std::string& verb, LockPatience patience) {
  const std::filesystem::path file = directory / ".lock";
  fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (fd_ < 0) {
    fail(Exit::failed, "{}: cannot open the lock: {}. Check the directory's permissions and the disk's free space.",
         file.string(), std::strerror(errno));
  }
  if (!wait_for_lock(fd_, patience)) {
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
