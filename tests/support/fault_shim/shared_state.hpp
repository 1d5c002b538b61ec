// SPDX-License-Identifier: BSD-3-Clause
// What the shim in the programs under test and the test itself share: a small file that both map, and the names of the
// environment.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace rouleau::testing {

inline constexpr const char* fault_directory_variable = "FAULT_DIRECTORY";  ///< calls on files below it are watched
inline constexpr const char* fault_program_variable = "FAULT_PROGRAM";      ///< of programs with this name, or of all
inline constexpr const char* fault_state_variable = "FAULT_STATE";          ///< the file with the FaultState
inline constexpr const char* fault_log_variable = "FAULT_LOG";  ///< where the calls are recorded, or nowhere

/// What happens at the call.
enum class Fault : std::int32_t {
  none,
  error,  ///< it fails with `error_number` and does nothing
  brief,  ///< a write or read does half of its work and says so; other calls go well
  kill,   ///< the process is killed before the call
  torn,   ///< a write does half of its work, then the process is killed; other calls: nothing happens
  stop,   ///< the process is stopped (SIGSTOP) before the call
};

/// Which calls are watched: those that may change what is on the disk, or those that ask for what is there.
enum class Watch : std::int32_t { changes, reads };

/// Zero at the start; all processes of a run count together.
struct FaultState {
  std::atomic<std::int64_t> calls;     ///< watched calls so far
  std::atomic<std::int64_t> injected;  ///< faults so far
  std::atomic<std::int64_t> victim;    ///< the process that had the newest
  std::int64_t at;                     ///< the call, from 1, that the fault comes at; 0: none
  Watch watch;
  Fault fault;
  std::int32_t error_number;
  std::int32_t lasts;                  ///< not 0: so do later calls (Injection)
  std::array<char, 32> name;           ///< of the call that the fault came at
  std::array<char, 1024> path, other;  ///< its file, and the new name of a rename
};

}  // namespace rouleau::testing
