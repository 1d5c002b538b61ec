// SPDX-License-Identifier: BSD-3-Clause
// Signals as something to wait for, so that nothing is interrupted in the middle of a step.
#pragma once

#include <signal.h>

#include <initializer_list>

namespace rouleau::campaign {

/// While it lives, SIGINT, SIGTERM, SIGHUP, SIGCHLD and those named do nothing by themselves and are returned by
/// wait().
class SignalWatch {
 public:
  explicit SignalWatch(std::initializer_list<int> more = {});
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

  /// The next signal, or 0 when `timeout_ms` have passed without one.
  int wait(int timeout_ms);

 private:
  sigset_t before_{};
  int fd_;
};

}  // namespace rouleau::campaign
