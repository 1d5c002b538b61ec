// SPDX-License-Identifier: BSD-3-Clause
// What a checkpoint of this run says about itself, and what it must agree with to be continued.
#pragma once

#include <map>
#include <string>

#include "run/setup.hpp"
#include "storage/metadata.hpp"

namespace rouleau {

/// The run's parameters as a checkpoint records them; files stand there by the digest of their content.
std::map<std::string, Parameter> recorded_parameters(const RunFile& run);

CheckpointMetadata checkpoint_metadata(const Setup& setup, std::int64_t step, int attempt,
                                       const SampleLogPosition& samples, const std::string& mesh_digest);

}  // namespace rouleau
