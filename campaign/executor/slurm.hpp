// SPDX-License-Identifier: BSD-3-Clause
// Slurm's programs: what the campaign asks of them, with a time-out, and what their answers mean.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "executor/capture.hpp"

namespace rouleau::campaign {

/// One job of ours as squeue shows it.
struct JobRow {
  std::string id;
  std::string name;
  std::string state;   ///< "PENDING"
  std::string nodes;   ///< "n[1-2]", "" while it has none
  std::string reason;  ///< "Priority", "None"
};

/// The answer to one query. A query that failed says nothing about any job.
struct JobList {
  bool answered = false;
  std::string trouble;       ///< why not, in one line
  std::vector<JobRow> rows;  ///< empty unless answered
};

/// The outcome of one submission.
struct Submission {
  std::string id;          ///< the job's number; "" = not submitted, as far as is known
  bool transient = false;  ///< try again later: no controller, no munge, a time-out, a full queue. It may have been
                           ///< submitted all the same: look for its name first
  std::string trouble;     ///< why not, in one line, with Slurm's own words
  std::string words;       ///< what sbatch said on success, in one line
};

/// Calls squeue, sbatch, scontrol and scancel by argument vectors, in an environment without SLURM_* (so that a manager
/// inside a job does not hand that job's size on). Throws nothing: every trouble is told in the answer.
class Slurm {
 public:
  explicit Slurm(double client_timeout_s) : client_timeout_s_(client_timeout_s) {}

  /// All jobs of this user that Slurm still knows, ended ones too.
  [[nodiscard]] JobList jobs() const;
  /// How often Slurm has started this job again; nothing if it does not say.
  [[nodiscard]] std::optional<int> restarts(const std::string& id) const;
  /// Whether Slurm would take this script. On success `id` is the number that it would have had; nothing is submitted.
  [[nodiscard]] Submission test_only(const std::filesystem::path& script) const;
  /// Submits a script that waits until it is released.
  [[nodiscard]] Submission submit_held(const std::filesystem::path& script) const;
  /// Lets a held job go.   returns "" if it is not held any more, else the trouble in one line
  [[nodiscard]] std::string release(const std::string& id) const;
  /// Ends a job.   returns "" if it was told to end or has ended already, else the trouble in one line
  [[nodiscard]] std::string cancel(const std::string& id) const;

 private:
  double client_timeout_s_;
};

/// The rows of `squeue -h -o %i|%j|%T|%N|%r`. Lines that are none (a site's greetings) are left out.
[[nodiscard]] std::vector<JobRow> parse_job_rows(std::string_view text);

/// The job's number from what `sbatch --parsable` said: the last line that is a number, or a number;cluster; else "".
[[nodiscard]] std::string parse_job_id(std::string_view text);

/// The number in what `squeue -h -O RestartCnt` said: the last line that is nothing else.
[[nodiscard]] std::optional<int> parse_restarts(std::string_view text);

/// Whether an error text of Slurm tells of a state that passes (no controller, no munge, a full queue), rather than of
/// a request that was refused.
[[nodiscard]] bool is_transient(std::string_view error);

}  // namespace rouleau::campaign
