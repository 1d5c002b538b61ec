// SPDX-License-Identifier: BSD-3-Clause
// Which faults a test injects: a sample of all calls and kinds in ctest; with SOAK in the environment every kind at
// every call, or at FAULTS (a number, not per cent) of those of each test. And the count of what was done, printed as
// one line of JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/fault_shim/call_log.hpp"
#include "support/fault_shim/faults.hpp"

namespace rouleau::testing {

/// True for the long form (SOAK is set), which also goes on after a failure.
[[nodiscard]] bool is_long_form();

/// Faults at the calls of an undisturbed run. Short form: about `sample` of them, spread evenly, the kinds in turn;
/// what can only happen to a write or read comes at the next one. Reads fail with EIO, once or for good, or are short.
[[nodiscard]] std::vector<Injection> planned_faults(const std::vector<RecordedCall>& calls, std::int64_t sample,
                                                    Watch watch = Watch::changes);

/// About `sample` of the numbers 1 to `count`, spread evenly; all of them in the long form; or FAULTS of them.
[[nodiscard]] std::vector<std::int64_t> planned_places(std::int64_t count, std::int64_t sample);

/// What all tests of the program have done, and what it has cost.
struct Tally {
  std::int64_t faults_injected = 0;  ///< all of them
  std::int64_t injected_kills = 0;   ///< those of them that killed
  std::int64_t power_losses = 0, freezes = 0;
  std::int64_t lost_samples = 0;   ///< ends whose samples were others
  std::int64_t wrong_resumes = 0;  ///< checkpoints taken for damaged, or campaigns with another end
  std::int64_t manual_steps = 0;   ///< times that the plain command did not do
};
Tally& tally();
/// Counts a fault that has happened.
void count(const Injection& injection);

}  // namespace rouleau::testing
