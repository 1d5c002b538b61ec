// SPDX-License-Identifier: BSD-3-Clause
// Writing a checkpoint: one file a generation, whole or not there.
//
// The file is HDF5, independent of the number of ranks and readable with any HDF5 tool:
//   bytes 0..511          seal: length and checksum of all bytes that follow (seal.hpp); HDF5 calls this a user block
//   /<lattice item>       [component][z][y][x], in the item's own precision, contiguous
//   /<replicated item>    as shaped in the state
//   /metadata             JSON text (metadata.hpp)
//   /manifest             JSON text: layout version, lattice, name, type, shape and checksums of every item, checksum
//   of the
//                         metadata (manifest.hpp)
//   /manifest_checksum    XXH3-64 of the manifest's bytes, 16 hex digits
// The manifest's checksums are taken from memory before anything is written, so they cover the way to the disk too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "parallel/communicator.hpp"
#include "storage/files.hpp"
#include "storage/metadata.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// Where checkpoints go and under which rules.
struct CheckpointPlace {
  FileSystem& files;
  std::filesystem::path directory;  ///< `checkpoints/` of the run; made if missing
  std::function<void()> fence;      ///< throws Error(superseded) if a newer attempt exists; called on rank 0
  int keep = 3;                     ///< generations, at least 1
};

struct SavedCheckpoint {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
};

/// The name of a generation: 12-digit step and ".h5".
[[nodiscard]] std::string checkpoint_name(std::int64_t step);

/// Writes the state of all ranks as `<directory>/<step>.h5`. Collective: all ranks return, or all throw the same Error.
///
/// Order of events: values finite -> fence -> room on the disk -> rank 0 lays out the file and reserves its blocks ->
/// each rank writes whole planes -> sync -> seal -> sync -> the file is opened anew and every value compared by
/// checksum with memory -> fence -> rename -> sync of the directory -> generations beyond the newest `keep` are
/// removed, and so are any of a later step: those a resume has rejected. A failure before the rename leaves the older
/// generations untouched and removes the unfinished file.
///
/// reads   metadata  rank 0's; its step names the file
/// throws  Error(physics) if values are not finite, or replicated items differ between ranks;
///         Error(superseded) by the fence; Error(io) otherwise
SavedCheckpoint save_checkpoint(const CheckpointPlace& place, const Communicator& comm, const PersistentState& state,
                                const CheckpointMetadata& metadata);

/// 32 hex digits over names, types, shapes and every bit of the state of all ranks; independent of the decomposition.
/// Equals CheckpointReport::digest of a checkpoint of the same state. Collective.
[[nodiscard]] std::string digest(const PersistentState& state, const Communicator& comm);

}  // namespace rouleau
