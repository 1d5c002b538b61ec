// SPDX-License-Identifier: BSD-3-Clause
// Putting a state into an HDF5 file in two acts: rank 0 lays the file out, then all ranks write their part of the
// values.
//
// The lattice values do not pass through HDF5's parallel interface but go straight to the places that the layout gives
// them, as contiguous pieces. With MPI-IO underneath, a write that fails on one rank (disk full) leaves the others
// waiting in a collective call for ever (Open MPI 4.1.4, measured); here the only collective call moves memory, and
// every write is a rank's own, with its own error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "parallel/communicator.hpp"
#include "storage/files.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// The texts that a checkpoint carries.
struct CheckpointTexts {
  std::string metadata;
  std::string manifest;
};

/// Makes the file with all datasets, the texts and the replicated items, and reserves every block on the disk. Returns
/// where in the file the values of each lattice item begin. For rank 0. Throws Error(io).
[[nodiscard]] std::vector<std::uint64_t> lay_out_checkpoint(FileSystem& files, const std::filesystem::path& path,
                                                            const PersistentState& state, const CheckpointTexts& texts);

/// Writes the values of the lattice items to those places and syncs them. Collective; a failure of any rank is an
/// Error(io) on all.
void write_lattice_items(FileSystem& files, const std::filesystem::path& path, const Communicator& comm,
                         const PersistentState& state, const std::vector<std::uint64_t>& places);

}  // namespace rouleau
