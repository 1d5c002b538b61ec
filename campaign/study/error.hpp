// SPDX-License-Identifier: BSD-3-Clause
// The one exception type of the campaign manager, and the exit codes that `rouleau` ends with.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace rouleau::campaign {

/// Exit codes of the command line. Scripts may rely on them.
enum class Exit {
  ok = 0,
  failed = 1,              ///< the operation failed
  usage = 2,               ///< the command line or the study file is wrong
  not_found = 3,           ///< nothing matched
  some_failed = 4,         ///< some points failed, were refused or used up their retries
  locked = 5,              ///< another live process holds the campaign's lock
  engine_unreachable = 6,  ///< the engine did not answer: try again later
  damaged = 7,             ///< an integrity problem was found
  interrupted = 130,       ///< ended by Ctrl-C or SIGTERM
};

/// A failure that the user must know of: one line that says what, where, the value, the limit, what to do next.
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

/// Checks a promise that our own code makes to itself.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace rouleau::campaign
