// SPDX-License-Identifier: BSD-3-Clause
// Who may ask a run to stop behind a checkpoint: a signal, a deadline, a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "parallel/communicator.hpp"

namespace rouleau {

/// Catches SIGTERM, SIGINT and SIGUSR2 for the life of the process. (share/contract.md section 2)
void catch_stop_signals();

class StopWatch {
 public:
  /// `until`, if any: the deadline on the clock of monotonic_s(); `stop_file` is looked for about once a second.
  StopWatch(const Communicator& comm, std::optional<double> until, std::filesystem::path stop_file);

  /// Seconds that a checkpoint takes: the deadline is met if it is begun that long before. Twice the last one, at least
  /// 2 s.
  void expect_checkpoint(double seconds) { checkpoint_s_ = seconds; }

  /// Why to stop now, or nothing. All ranks get the same answer; all must call it at the same step.
  [[nodiscard]] std::optional<std::string> reason();

 private:
  enum Reason { none, deadline, file, signal };
  [[nodiscard]] Reason own_reason();

  const Communicator& comm_;
  std::optional<double> deadline_;
  std::filesystem::path stop_file_;
  double next_look_ = 0;
  double checkpoint_s_ = 1;
};

/// Seconds on a clock that only runs forward.
double monotonic_s();
/// Seconds since 1970.
double unix_s();

}  // namespace rouleau
