// SPDX-License-Identifier: BSD-3-Clause
// What the campaign manager reads: study files, and what solvers leave in run directories.
#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "executor/job_script.hpp"
#include "executor/slurm.hpp"
#include "fuzz/formats.hpp"
#include "ingest/ingest.hpp"
#include "ingest/run_files.hpp"
#include "ingest/sample_log.hpp"
#include "jobs/slurm_state.hpp"
#include "report/analysis.hpp"
#include "store/store.hpp"
#include "study/check.hpp"
#include "study/cluster.hpp"
#include "study/error.hpp"
#include "study/run_file.hpp"

namespace rouleau::fuzz {

namespace {

using namespace rouleau::campaign;

/// A file in memory that has a path, for readers that open their files themselves.
class NamedMemory {
 public:
  explicit NamedMemory(std::string_view bytes) : file_(::memfd_create("fuzzed", MFD_CLOEXEC)) {
    require(file_ >= 0 && ::write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()), "memfd");
  }
  ~NamedMemory() { ::close(file_); }
  NamedMemory(const NamedMemory&) = delete;
  NamedMemory& operator=(const NamedMemory&) = delete;
  [[nodiscard]] std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

/// Stands in for files that the study names, without touching the disk.
NamedFiles pretended_files(const Study& study) {
  NamedFiles files;
  const auto add = [&](const std::string& name, const std::string& value) {
    if (names_a_file(name)) files[value] = {"/nowhere", "files/mesh.off"};
  };
  for (const Entry& entry : study.fixed) add(entry.name, entry.value);
  for (const Axis& axis : study.axes) {
    for (const std::string& value : axis.values) add(axis.name, value);
  }
  return files;
}

}  // namespace

void read_study(std::string_view bytes) {
  const Study study = parse_study(std::string(bytes), "study.ini");
  const NamedFiles files = pretended_files(study);
  static_cast<void>(with_stored_files(study, files));
  const auto count = static_cast<std::size_t>(count_of(study));
  for (const std::size_t index : {std::size_t{0}, count - 1}) {
    const RunFile run_file = run_file_of(combination_of(study, index), files, FileNames::stored, study.name);
    // A solver's message quotes what the study says.
    static_cast<void>(to_study_lines("run.ini:3: " + study.text, run_file, "study.ini"));
  }
}

void read_campaign_log(std::string_view bytes) {
  const NamedMemory file(bytes);
  const LogPart whole = read_sample_log(file.path(), {});
  static_cast<void>(analyse("fuzzed", whole.rows, Analysis{}));
  const LogPart again = read_sample_log(file.path(), whole.mark);
  require(again.rows.empty() || again.from_start, "a log that has not changed has new rows");
}

void read_records(std::string_view bytes) {
  const NamedMemory file(bytes);
  std::vector<std::string> warnings;
  static_cast<void>(read_process_file(file.path(), warnings));
  static_cast<void>(read_progress_file(file.path(), warnings));
  static_cast<void>(read_job_file(file.path(), warnings));
  static_cast<void>(read_status_file(file.path(), warnings));
  static_cast<void>(read_start_file(file.path(), warnings));
  if (const auto exit = read_exit_file(file.path(), warnings); exit && exit->finished_unix_s)
    static_cast<void>(iso_utc(*exit->finished_unix_s));
}

void read_point_file(std::string_view bytes) {
  const NamedMemory file(bytes);
  const Point point = read_point(file.path());
  static_cast<void>(point.label());
  static_cast<void>(parameter_rows_of(point));
}

void read_check_reply(std::string_view bytes) { static_cast<void>(parse_check(std::string(bytes))); }

void read_cluster_file(std::string_view bytes) {
  const Cluster cluster = parse_cluster(std::string(bytes), "cluster.ini");
  require(cluster.time_limit_s > 0, "a cluster file without a time limit was taken");
  JobScript job{"/opt/rouleau-solver", "/home/campaign", "rouleau-fuzzed", 2, {{"0123456789ab", 1, "00"}}, {}};
  require(!job_script(cluster, job).empty(), "no script");
}

void read_scheduler(std::string_view bytes) {
  for (const JobRow& row : parse_job_rows(bytes))
    require(!view_of(row.state, row.reason, row.nodes).words.empty(), "a job of which nothing can be said");
  static_cast<void>(parse_job_id(bytes));
  static_cast<void>(parse_restarts(bytes));
  static_cast<void>(is_transient(bytes));
  static_cast<void>(seconds_of_time_limit(std::string(bytes)));
}

}  // namespace rouleau::fuzz
