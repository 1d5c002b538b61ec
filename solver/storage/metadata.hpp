// SPDX-License-Identifier: BSD-3-Clause
// What a checkpoint says about itself besides the state: which run, which moment, which code.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rouleau {

/// Version of the file layout that this solver writes and reads.
inline constexpr int checkpoint_layout = 1;

/// A parameter of the run file in canonical form. An identity parameter must not change between parts of a run.
struct Parameter {
  std::string value;
  std::string default_value;
  bool identity = true;
  bool operator==(const Parameter&) const = default;
};

/// A point of the sample log that is safely on disk: its length, and the XXH64 of all bytes up to there (16 hex
/// digits).
struct SampleLogPosition {
  std::uint64_t bytes = 0;
  std::string hash;
  bool operator==(const SampleLogPosition&) const = default;
};

struct CheckpointMetadata {
  int layout = checkpoint_layout;
  int contract = 1;
  std::int64_t step = 0;
  double time_s = 0;
  int attempt = 0;                              ///< that wrote it
  std::map<std::string, Parameter> parameters;  ///< by "section.name"
  std::string identity;                         ///< digest of the run's identity (contract section 2)
  std::string version, git;                     ///< of the code
  SampleLogPosition samples;
  std::string mesh_digest;     ///< of the cells' topology and reference shape
  double node_spacing_um = 0;  ///< of the lattice that positions refer to
  bool operator==(const CheckpointMetadata&) const = default;
};

/// One JSON object, two spaces of indentation, keys in a fixed order. Throws Error(physics) if a number is not finite.
[[nodiscard]] std::string to_json(const CheckpointMetadata& metadata);

/// Reads what to_json wrote; a missing or mistyped entry is an Error(bad_input) that names `file` and the entry.
/// If the layout version is another one, only that and the code's version are read.
[[nodiscard]] CheckpointMetadata metadata_from_json(const std::string& text, const std::string& file);

}  // namespace rouleau
