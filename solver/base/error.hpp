// SPDX-License-Identifier: BSD-3-Clause
// The one exception type of the solver, and the exit codes it ends with.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace rouleau {

/// Exit codes of the contract (share/contract.md section 6).
enum class Exit {
  finished = 0,
  internal = 1,  ///< a broken promise of our own code; to a manager the same as a crash
  usage = 64,
  bad_input = 65,
  physics = 70,
  io = 74,
  stopped = 75,
  superseded = 76,
};

/// A failure that the outside world caused or must know of: one line that says what, where, the value, the limit, what
/// to do.
class Error : public std::runtime_error {
 public:
  Error(Exit code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] Exit code() const { return code_; }

 private:
  Exit code_;
};

template <class... Args>
[[noreturn]] void fail(Exit code, fmt::format_string<Args...> format, Args&&... args) {
  throw Error(code, fmt::format(format, std::forward<Args>(args)...));
}

/// Checks a promise that our own code makes to itself, outside hot loops.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace rouleau
