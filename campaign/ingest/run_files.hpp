// SPDX-License-Identifier: BSD-3-Clause
// The files of a run directory that a solver or a launcher leaves (share/contract.md sections 5 to 7), read without
// trust.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rouleau::campaign {

/// process.json or started.json.
struct ProcessFile {
  std::string host, boot_id;
  std::int64_t pid = 0, start_ticks = 0;
  int ranks = 0;
  std::optional<std::int64_t> checkpoint_step;  ///< process.json: newest checkpoint before the start; -1 = none
  std::optional<double> started_unix_s;         ///< process.json

  friend bool operator==(const ProcessFile&, const ProcessFile&) = default;
};

/// exit.json.
struct ExitFile {
  int code = 0;
  std::string reason, host, resumed_from, version, git;
  std::optional<std::int64_t> start_step, step, end_step;
  std::optional<double> wall_s, core_s, mlups, finished_unix_s;
  std::optional<int> ranks;

  friend bool operator==(const ExitFile&, const ExitFile&) = default;
};

/// progress.json.
struct ProgressFile {
  int attempt = 0;
  std::int64_t step = 0, end_step = 0;
  double time_s = 0, end_time_s = 0;
  std::optional<std::int64_t> checkpoint_step;
  std::optional<double> steps_per_s, mlups, eta_s, checkpoint_unix_s, checkpoint_ms, d_um, asphericity, updated_unix_s;

  friend bool operator==(const ProgressFile&, const ProgressFile&) = default;
};

/// attempts/<k>/job of an attempt that was handed to Slurm (share/contract.md section 14): "slurm ID NAME".
struct JobFile {
  std::string id;  ///< "" = written before the submission, as "-"
  std::string name;

  friend bool operator==(const JobFile&, const JobFile&) = default;
};

/// Each returns nothing when the file is not there, and nothing plus a line in `warnings` when it is damaged.
std::optional<ProcessFile> read_process_file(const std::filesystem::path& file, std::vector<std::string>& warnings);
std::optional<ExitFile> read_exit_file(const std::filesystem::path& file, std::vector<std::string>& warnings);
std::optional<ProgressFile> read_progress_file(const std::filesystem::path& file, std::vector<std::string>& warnings);

std::optional<JobFile> read_job_file(const std::filesystem::path& file, std::vector<std::string>& warnings);
/// attempts/<k>/status: what the launcher of a job script ended with.
std::optional<int> read_status_file(const std::filesystem::path& file, std::vector<std::string>& warnings);
/// attempts/<k>/start: how often Slurm had started the job again when its script took the attempt.
std::optional<int> read_start_file(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// The first line of a text file (attempts/<k>/owner), or nothing when there is none.
std::optional<std::string> read_first_line(const std::filesystem::path& file);

/// The entries of a folder, none if there is no such folder.   throws Error if that cannot be told
std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder);

/// The numbers of the folders in attempts/, ascending; other names are left alone.
std::vector<int> attempt_numbers(const std::filesystem::path& run_directory);

/// The steps of the files <12 digits>.h5 in checkpoints/, ascending. Says nothing about whether they verify.
std::vector<std::int64_t> checkpoint_steps(const std::filesystem::path& run_directory);

}  // namespace rouleau::campaign
