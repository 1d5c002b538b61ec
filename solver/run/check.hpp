// SPDX-License-Identifier: BSD-3-Clause
// What `rouleau-solver check` answers (share/contract.md section 2).
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "run/lattice_parameters.hpp"

namespace rouleau {

/// What only the set-up knows.
struct CheckCounts {
  std::int64_t triangles = 0, vertices = 0, cells = 0;
  std::int64_t checkpoint_bytes = 0, snapshot_bytes = 0;
};

/// Cost of a step in updates of one fluid node; what the campaign scales measured speeds with.
double relative_cost_per_step(std::int64_t nodes, std::int64_t vertices);

/// The object of the contract. `samples` counts the instants sampled, step 0 included.
nlohmann::ordered_json check_json(const RunFile& run, const LatticeParameters& lattice, const CheckCounts& counts,
                                  const std::vector<std::string>& warnings);

}  // namespace rouleau
