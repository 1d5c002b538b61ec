// SPDX-License-Identifier: BSD-3-Clause
// The seal of a checkpoint file: 512 bytes at its start that vouch for the length and every byte of the rest.
//
// It is checked before the HDF5 library sees the file, because that library trusts what it reads. The text is readable
// with `head -c 512`. It holds the sum over all 1 MiB chunks of mix(chunk number, XXH3-64 of the chunk), which ranks
// can share out.
#pragma once

#include <cstdint>
#include <filesystem>

#include "parallel/communicator.hpp"
#include "storage/files.hpp"

namespace rouleau {

inline constexpr std::uint64_t seal_bytes = 512;  ///< the smallest HDF5 user block

/// One rank's share of the work of reading a file.
struct Share {
  int part = 0, parts = 1;
};

/// This share's part of the seal's sum; the parts add up modulo 2^64. Throws Error(io).
[[nodiscard]] std::uint64_t seal_part(FileSystem& files, const std::filesystem::path& path, std::uint64_t length,
                                      Share share);

/// Writes the seal over the first 512 bytes and syncs the file. Collective; rank 0 writes.
void write_seal(FileSystem& files, const std::filesystem::path& path, const Communicator& comm);

/// Throws Error(bad_input) if the file is not exactly what was sealed, Error(io) if it cannot be read.
void require_seal(FileSystem& files, const std::filesystem::path& path);                            // one process
void require_seal(FileSystem& files, const std::filesystem::path& path, const Communicator& comm);  // collective

}  // namespace rouleau
