// SPDX-License-Identifier: BSD-3-Clause
// Where and with what was measured, and whether anybody else was busy there.
#pragma once

#include <nlohmann/json.hpp>

#include "parallel/communicator.hpp"

namespace rouleau::speed {

/// Processor, caches, memory, system.
nlohmann::ordered_json machine_facts();
/// Solver, commit, compiler with its options, libraries.
nlohmann::ordered_json version_facts();

/// Processor time between two moments, of the whole machine and of the ranks that measure.
class ForeignLoad {
 public:
  /// Collective, as is `facts`. `comm` must outlive it.
  explicit ForeignLoad(const Communicator& comm);
  /// Load averages and, since construction, `cores_busy_with_others` and `cores_stolen` by the hypervisor.
  [[nodiscard]] nlohmann::ordered_json facts() const;

 private:
  struct Moment {
    double wall_s = 0, busy_s = 0, stolen_s = 0, own_s = 0;
  };
  [[nodiscard]] Moment now() const;

  const Communicator& comm_;
  std::array<double, 3> load_at_begin_{};
  Moment begin_;
};

/// More of others' work than this many cores is worth a warning.
inline constexpr double tolerable_foreign_cores = 0.1;

}  // namespace rouleau::speed
