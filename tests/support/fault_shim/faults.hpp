// SPDX-License-Identifier: BSD-3-Clause
// File-system faults in programs that a test starts: as long as an object lives, they run with the shim loaded.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>

#include "support/fault_shim/shared_state.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {

/// A fault at the n-th watched call of all started programs together.
struct Injection {
  std::int64_t at = 0;  ///< from 1; 0: none
  Fault fault = Fault::none;
  int error_number = 0;
  bool lasts = false;  ///< all later calls that need room on the disk fail too; of reads, all later ones of that file
  Watch watch = Watch::changes;
};

/// The call that a fault has come at.
struct StruckCall {
  std::string name;         ///< as in RecordedCall
  std::string path, other;  ///< absolute
};

class Faults {
 public:
  /// Watches the files below `directory`, in programs with this name ("" for all).
  Faults(const std::filesystem::path& directory, const std::string& program, const Injection& injection);
  ~Faults();
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  /// From now on programs record their calls (call_log.hpp).
  void record();
  /// Programs started from now on run without the shim.
  void let_go();

  [[nodiscard]] std::int64_t calls() const { return state_->calls; }
  [[nodiscard]] std::int64_t injected() const { return state_->injected; }
  /// What the call was; another than the recorded one of that number, where clock or ranks have changed the order.
  [[nodiscard]] StruckCall struck() const { return {state_->name.data(), state_->path.data(), state_->other.data()}; }
  [[nodiscard]] pid_t victim() const { return static_cast<pid_t>(state_->victim.load()); }
  [[nodiscard]] std::filesystem::path log() const { return place_.path() / "calls"; }

 private:
  TemporaryDirectory place_;
  FaultState* state_;
};

/// "EIO", "short write", "kill", ...
[[nodiscard]] std::string name_of(const Injection& injection);

/// Waits until a fault has stopped a process (`true`), or until `is_over` (`false`).
[[nodiscard]] bool has_stopped(const Faults& faults, const std::function<bool()>& is_over);

}  // namespace rouleau::testing
