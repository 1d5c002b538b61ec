// SPDX-License-Identifier: BSD-3-Clause
// Calling Slurm's programs and reading their answers.
#include "executor/slurm.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "study/error.hpp"
#include "study/ini.hpp"

namespace rouleau::campaign {

namespace {

constexpr const char* row_format = "%i|%j|%T|%N|%r";  // the reason last: it may hold anything

/// Parts of Slurm's error texts that tell of a state that passes.
constexpr std::string_view transient_texts[] = {
    "unable to contact slurm controller",
    "unable to establish",  // ... configuration source, ... controller address
    "could not establish a configuration source",
    "socket timed out",
    "connection refused",
    "connection timed out",
    "connection reset",
    "communication connection failure",
    "transport endpoint",
    "no route to host",
    "zero bytes were transmitted",
    "slurmctld communications",
    "controller is in standby",
    "controller in standby",
    "temporarily unable",
    "temporarily unavailable",
    "authentication error",
    "authentication credential",
    "authentication agent",
    "munge",
    "i/o error writing",
    "not available right now",
    "not available now",                 // the partition's configuration
    "required partition not available",  // (inactive or drain): maintenance
    "required node not available",       // (down, drained or reserved)
    "maxsubmitjob",        // AssocMaxSubmitJobLimit, QOSMaxSubmitJobPerUserLimit: room comes when jobs end
    "grpsubmitjobslimit",  // AssocGrpSubmitJobsLimit
    "unable to allocate memory",
    "cannot allocate memory",
};

/// The last lines of a program's errors as one line.
std::string in_one_line(const std::string& text) {
  std::string joined;
  for (const std::string& line : split(text, '\n')) {
    if (line.empty()) continue;
    if (!joined.empty()) joined += "; ";
    joined += line;
  }
  constexpr std::size_t longest = 600;
  return joined.size() <= longest ? joined : "..." + joined.substr(joined.size() - longest);
}

/// How a call ended.
struct Answer {
  Capture capture;
  std::string trouble;  ///< "" if the program ended with 0
  bool transient = false;
};

Answer ask(const std::vector<std::string>& command, double time_out_s) {
  Answer answer;
  try {
    answer.capture = run_and_capture(
        command,
        CaptureSettings{.directory = {}, .time_out_s = time_out_s, .environment = environment_without_slurm()});
  } catch (const Error& error) {
    answer.trouble = fmt::format("{} Is Slurm installed here, and on the PATH?", error.what());
    answer.transient = true;
    return answer;
  }
  const Capture& capture = answer.capture;
  const std::string& words = capture.err.find_first_not_of(" \n") == std::string::npos ? capture.out : capture.err;
  if (capture.timed_out) {
    answer.trouble = fmt::format("{} gave no answer within {} s and was ended", command.front(), time_out_s);
    if (!in_one_line(words).empty()) answer.trouble += ": " + in_one_line(words);
    answer.transient = true;
  } else if (capture.status != 0) {
    const bool was_killed = capture.status > 128;
    answer.trouble = fmt::format("{} ended with status {}: {}", command.front(), capture.status,
                                 in_one_line(words).empty() ? "no message" : in_one_line(words));
    answer.transient = was_killed || is_transient(capture.err) || is_transient(capture.out);
  }
  return answer;
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// A job's number as squeue shows it: 12, and 12_3 or 12_[1-4] of arrays, which are not ours.
bool is_job_number(std::string_view text) {
  return is_number(text.substr(0, text.find('_'))) && text.find(' ') == std::string_view::npos;
}

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

}  // namespace

std::vector<JobRow> parse_job_rows(std::string_view text) {
  std::vector<JobRow> rows;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    JobRow row;
    const std::array<std::string*, 4> fields = {&row.id, &row.name, &row.state, &row.nodes};
    bool is_row = true;
    for (std::string* field : fields) {
      const std::size_t bar = line.find('|');
      is_row = is_row && bar != std::string_view::npos;
      if (!is_row) break;
      *field = trimmed(std::string(line.substr(0, bar)));
      line.remove_prefix(bar + 1);
    }
    if (!is_row || !is_job_number(row.id)) continue;
    row.reason = trimmed(std::string(line));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string parse_job_id(std::string_view text) {
  std::string id;
  for (const std::string& line : split(std::string(text), '\n')) {
    const std::size_t semicolon = line.find(';');
    const bool has_good_cluster =
        semicolon == std::string::npos ||
        (semicolon + 1 < line.size() && line.find_first_of(" \t;", semicolon + 1) == std::string::npos);
    if (is_number(line.substr(0, semicolon)) && has_good_cluster) id = line.substr(0, semicolon);
  }
  return id;
}

std::optional<int> parse_restarts(std::string_view text) {
  constexpr std::size_t most_digits = 6;
  std::optional<int> restarts;
  for (const std::string& line : split(std::string(text), '\n')) {
    const std::string word = trimmed(line);
    if (is_number(word) && word.size() <= most_digits) restarts = std::stoi(word);
  }
  return restarts;
}

bool is_transient(std::string_view error) {
  std::string lower(error);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::any_of(std::begin(transient_texts), std::end(transient_texts),
                     [&](std::string_view part) { return lower.find(part) != std::string::npos; });
}

JobList Slurm::jobs() const {
  const Answer answer =
      ask({"squeue", "-h", "-u", std::to_string(::getuid()), "-t", "all", "-o", row_format}, client_timeout_s_);
  JobList list;
  list.answered = answer.trouble.empty();
  list.trouble = answer.trouble;
  if (list.answered) list.rows = parse_job_rows(answer.capture.out);
  return list;
}

std::optional<int> Slurm::restarts(const std::string& id) const {
  const Answer answer = ask({"squeue", "-h", "-j", id, "-O", "RestartCnt"}, client_timeout_s_);
  if (!answer.trouble.empty()) return std::nullopt;
  return parse_restarts(answer.capture.out);
}

Submission Slurm::test_only(const std::filesystem::path& script) const {
  const Answer answer = ask({"sbatch", "--test-only", script.string()}, client_timeout_s_);
  Submission submission;
  submission.trouble = answer.trouble;
  submission.transient = answer.transient;
  if (!answer.trouble.empty()) return submission;
  submission.words = in_one_line(answer.capture.err.empty() ? answer.capture.out : answer.capture.err);
  // "sbatch: Job 12 to start at 2026-01-01T00:00:00 using 1 processors on nodes n1 in partition debug"
  const std::size_t job = submission.words.find("Job ");
  const std::string number = job == std::string::npos ? "" : submission.words.substr(job + 4);
  submission.id = number.substr(0, number.find_first_not_of("0123456789"));
  if (submission.id.empty()) submission.id = "?";
  return submission;
}

Submission Slurm::submit_held(const std::filesystem::path& script) const {
  const Answer answer = ask({"sbatch", "--parsable", "--hold", script.string()}, client_timeout_s_);
  Submission submission;
  submission.trouble = answer.trouble;
  submission.transient = answer.transient;
  if (!answer.trouble.empty()) return submission;
  submission.id = parse_job_id(answer.capture.out);
  submission.words = in_one_line(answer.capture.err);
  if (submission.id.empty()) {
    // It may have been submitted: whoever looks for its name in the queue will find it.
    submission.transient = true;
    submission.trouble = fmt::format("sbatch named no job number; it said: {}", in_one_line(answer.capture.out));
  }
  return submission;
}

std::string Slurm::release(const std::string& id) const {
  const Answer answer = ask({"scontrol", "release", id}, client_timeout_s_);
  const bool has_gone = says(answer.trouble, "no longer pending") || says(answer.trouble, "already finished");
  return has_gone ? "" : answer.trouble;
}

std::string Slurm::cancel(const std::string& id) const {
  const Answer answer = ask({"scancel", id}, client_timeout_s_);
  const bool is_gone =
      says(answer.trouble, "Invalid job id") || says(answer.trouble, "already completing or completed");
  return is_gone ? "" : answer.trouble;
}

}  // namespace rouleau::campaign
