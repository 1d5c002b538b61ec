// SPDX-License-Identifier: BSD-3-Clause
// One attempt at a run: claim it, resume or start, loop, leave an exit record.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/vec3.hpp"
#include "parallel/communicator.hpp"
#include "storage/file_system.hpp"

namespace rouleau {

struct RunOptions {
  std::filesystem::path run_file;
  std::optional<int> attempt;      ///< made by a manager; none: claim the next
  std::string token;               ///< of that attempt
  std::optional<double> deadline;  ///< on the clock of monotonic_s()
  Int3 ranks{0, 0, 0};             ///< the cut of the lattice; zeros: chosen
  bool quiet = false;
};

/// Runs to the end time or until asked to stop. Collective; all ranks return, or throw, alike.
/// Whatever happens after the attempt was claimed stands in its exit.json.
Exit run_attempt(const RunOptions& options, const Communicator& comm, FileSystem& files);

}  // namespace rouleau
