// SPDX-License-Identifier: BSD-3-Clause
// signalfd and poll.
#include "executor/signals.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "study/error.hpp"

namespace rouleau::campaign {

SignalWatch::SignalWatch(std::initializer_list<int> more) {
  sigset_t watched;
  sigemptyset(&watched);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&watched, signal);
  for (const int signal : more) sigaddset(&watched, signal);
  // Under nohup the user has asked for SIGHUP to be ignored; it stays so.
  struct sigaction hangup {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaddset(&watched, SIGHUP);
  ::sigprocmask(SIG_BLOCK, &watched, &before_);
  fd_ = ::signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
  if (fd_ < 0) fail(Exit::failed, "cannot watch for signals: {}.", std::strerror(errno));
}

SignalWatch::~SignalWatch() {
  // A second Ctrl-C that came too late to be heeded must not kill us now that we are ending anyway.
  while (wait(0) != 0) {
  }
  ::close(fd_);
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int SignalWatch::wait(int timeout_ms) {
  pollfd waiting{fd_, POLLIN, 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return 0;
  signalfd_siginfo info{};
  return ::read(fd_, &info, sizeof info) == static_cast<ssize_t>(sizeof info) ? static_cast<int>(info.ssi_signo) : 0;
}

}  // namespace rouleau::campaign
