// SPDX-License-Identifier: BSD-3-Clause
// Continuing a run: the newest checkpoint that is whole and belongs to it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "parallel/communicator.hpp"
#include "storage/file_system.hpp"
#include "storage/metadata.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// What a checkpoint must agree with.
struct Expected {
  /// The run's parameters. Files named in the run file should appear here by the digest of their content. A branch (a
  /// run that goes on from another's checkpoint with, say, another viscosity contrast) marks what it changes as not
  /// identity.
  std::map<std::string, Parameter> parameters;
  /// The run's identity digest; empty for a branch, which has another by intent.
  std::string identity;
  /// Further conditions, asked on rank 0: a reason why this checkpoint cannot be continued exactly, or nothing.
  /// Pass the sample log's: [&](const CheckpointMetadata& m) { return log.obstacle(m.samples); }
  std::function<std::optional<std::string>(const CheckpointMetadata&)> obstacle;
};

struct RejectedCheckpoint {
  std::string file;  ///< name within the directory
  std::string why;
  bool foreign = false;  ///< intact, but of another run
};

struct Resumed {
  std::optional<CheckpointMetadata> metadata;  ///< of the checkpoint now in the state; none: start at step 0
  std::filesystem::path file;
  std::vector<RejectedCheckpoint> rejected;  ///< newest first
};

/// Nothing could be loaded although an intact checkpoint is there. `what` names the newest of those.
class NoneCanBeContinued : public Error {
 public:
  NoneCanBeContinued(const std::string& message, std::vector<RejectedCheckpoint> rejected)
      : Error(Exit::bad_input, message), rejected_(std::move(rejected)) {}
  /// All of them, newest first.
  [[nodiscard]] const std::vector<RejectedCheckpoint>& rejected() const { return rejected_; }

 private:
  std::vector<RejectedCheckpoint> rejected_;
};

/// The generations in a directory, newest first. Files with other names are not looked at.
[[nodiscard]] std::vector<std::filesystem::path> find_checkpoints(FileSystem& files,
                                                                  const std::filesystem::path& directory);

/// Loads the newest checkpoint that verifies into the arrays of `state`, for any decomposition. Collective.
/// Damaged files (seal, name, manifest, metadata, values) and files that cannot be continued (other layout version,
/// other items, another run's identity, `obstacle`) are rejected with a reason and the next older generation is tried.
/// leaves  `state` unspecified if nothing could be loaded: the caller starts anew or stops
/// throws  NoneCanBeContinued if nothing could be loaded although an intact checkpoint is there: a parameter that has
///         changed is named with its old and new value; Error(io) if a file cannot be read for a reason that may pass,
///         or if the medium cannot read one (EIO) and no other can be loaded
Resumed load_newest(FileSystem& files, const std::filesystem::path& directory, const Communicator& comm,
                    const Expected& expected, PersistentState& state);

/// Why a checkpoint with `recorded` parameters belongs to another run, one clause a parameter; nothing if it does not.
/// A parameter that only one side knows counts as having had its default.
[[nodiscard]] std::optional<std::string> identity_conflict(const CheckpointMetadata& recorded,
                                                           const Expected& expected);

}  // namespace rouleau
