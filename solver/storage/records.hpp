// SPDX-License-Identifier: BSD-3-Clause
// The small JSON records of a run: started.json, exit.json, progress.json (share/contract.md sections 5 to 7).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "storage/attempt.hpp"
#include "storage/file_system.hpp"
#include "storage/resume.hpp"

namespace rouleau {

/// What tells a process from any other that ever ran.
struct ProcessIdentity {
  std::string host;
  int pid = 0;
  std::uint64_t start_ticks = 0;  ///< field 22 of /proc/<pid>/stat
  std::string boot_id;
};

struct ExitRecord {
  Exit code = Exit::finished;
  std::string reason;
  std::int64_t step = 0, end_step = 0, start_step = 0;
  double wall_s = 0, core_s = 0;
  int ranks = 1;
  double mlups = 0;
  std::string host;
  std::string resumed_from;  ///< relative to the run directory; empty: step 0
  std::vector<RejectedCheckpoint> rejected_checkpoints;
  std::string version, git;
  double finished_unix_s = 0;
};

struct Progress {
  std::int64_t step = 0, end_step = 0;
  double time_s = 0, end_time_s = 0, steps_per_s = 0, mlups = 0;
  std::optional<double> eta_s;  ///< none: not known yet
  std::int64_t checkpoint_step = 0;
  double checkpoint_unix_s = 0, checkpoint_ms = 0;
  std::optional<double> d_um, asphericity;  ///< none: no cell
  double updated_unix_s = 0;
};

/// Of the calling process, from /proc and gethostname.
[[nodiscard]] ProcessIdentity this_process(FileSystem& files);

/// attempts/<k>/started.json
void write_started(FileSystem& files, const Attempt& attempt, const ProcessIdentity& process, int ranks);

/// `<attempt_directory>/exit.json`. Takes the directory, since bad input can end an attempt before it was joined.
void write_exit_record(FileSystem& files, const std::filesystem::path& attempt_directory, const ExitRecord& record);

/// progress.json of the run, after the fence. An entry without a value is left out.
void write_progress(FileSystem& files, const Attempt& attempt, const Progress& progress);

}  // namespace rouleau
