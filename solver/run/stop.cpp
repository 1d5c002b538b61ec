// SPDX-License-Identifier: BSD-3-Clause
#include "run/stop.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <csignal>

namespace rouleau {

namespace {

volatile std::sig_atomic_t caught_signal = 0;

extern "C" void remember_signal(int number) { caught_signal = number; }

}  // namespace

void catch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = remember_signal;
  action.sa_flags = SA_RESTART;
  for (const int number : {SIGTERM, SIGINT, SIGUSR2}) sigaction(number, &action, nullptr);
}

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double unix_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

StopWatch::StopWatch(const Communicator& comm, std::optional<double> until, std::filesystem::path stop_file)
    : comm_(comm), deadline_(until), stop_file_(std::move(stop_file)) {}

StopWatch::Reason StopWatch::own_reason() {
  if (caught_signal) return signal;
  if (!comm_.is_root()) return none;
  const double now = monotonic_s();
  if (deadline_ && now + std::max(2.0, 2 * checkpoint_s_) > *deadline_) return deadline;
  if (now < next_look_) return none;
  next_look_ = now + 1;
  std::error_code error;
  return std::filesystem::exists(stop_file_, error) ? file : none;
}

std::optional<std::string> StopWatch::reason() {
  std::int64_t agreed = own_reason();
  if (comm_.size() > 1) agreed = comm_.max(agreed);
  switch (agreed) {
    case signal:
      return "stop requested by signal";
    case file:
      return "stop requested by the file `stop`";
    case deadline:
      return "deadline";
    default:
      return std::nullopt;
  }
}

}  // namespace rouleau
