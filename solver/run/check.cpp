// SPDX-License-Identifier: BSD-3-Clause
#include "run/check.hpp"

#include <nlohmann/json.hpp>

#include "run/version.hpp"

namespace rouleau {

// A vertex with its two triangles takes about as long as 30 nodes: membrane forces, spreading, interpolation, tracking.
double relative_cost_per_step(std::int64_t nodes, std::int64_t vertices) {
  constexpr double nodes_per_vertex = 30;
  return static_cast<double>(nodes) + nodes_per_vertex * static_cast<double>(vertices);
}

nlohmann::ordered_json check_json(const RunFile& run, const LatticeParameters& lattice, const CheckCounts& counts,
                                  const std::vector<std::string>& warnings) {
  const RunParameters& p = run.parameters;
  auto parameters = nlohmann::ordered_json::array();
  for (const auto& v : run.values)
    parameters.push_back({{"name", v.name},
                          {"value", v.value},
                          {"default", v.default_value},
                          {"kind", v.kind == ParameterKind::identity ? "identity" : "free"},
                          {"given", v.given}});
  const std::int64_t nodes = lattice.lattice.nodes();
  return {{"contract", 1},
          {"version", version()},
          {"git", git_hash()},
          {"parameters", std::move(parameters)},
          {"identity", run.identity},
          {"steps", lattice.steps},
          {"time_step_us", p.numerics.time_step_us},
          {"nodes", nodes},
          {"triangles", counts.triangles},
          {"vertices", counts.vertices},
          {"cells", counts.cells},
          {"end_time_s", p.time.end_time_s},
          {"samples", lattice.steps / p.output.sample_interval_steps + 1},
          {"checkpoint_bytes", counts.checkpoint_bytes},
          {"snapshot_bytes", counts.snapshot_bytes},
          {"node_spacing_um", p.numerics.node_spacing_um},
          {"relative_cost_per_step", relative_cost_per_step(nodes, counts.vertices)},
          {"warnings", warnings}};
}

}  // namespace rouleau
