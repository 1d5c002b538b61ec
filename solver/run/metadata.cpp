// SPDX-License-Identifier: BSD-3-Clause
#include "run/metadata.hpp"

#include "run/version.hpp"

namespace rouleau {

std::map<std::string, Parameter> recorded_parameters(const RunFile& run) {
  std::map<std::string, Parameter> parameters;
  for (const ParameterValue& p : run.values)
    parameters[p.name] = {p.identity_value, p.default_value, p.kind == ParameterKind::identity};
  return parameters;
}

CheckpointMetadata checkpoint_metadata(const Setup& setup, std::int64_t step, int attempt,
                                       const SampleLogPosition& samples, const std::string& mesh_digest) {
  CheckpointMetadata metadata;
  metadata.step = step;
  metadata.time_s = setup.units.time_s(step);
  metadata.attempt = attempt;
  metadata.parameters = recorded_parameters(setup.run);
  metadata.identity = setup.run.identity;
  metadata.version = version();
  metadata.git = git_hash();
  metadata.samples = samples;
  metadata.mesh_digest = mesh_digest;
  metadata.node_spacing_um = setup.units.dx_um();
  return metadata;
}

}  // namespace rouleau
