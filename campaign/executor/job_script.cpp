// SPDX-License-Identifier: BSD-3-Clause
// The text of a job's script: options for sbatch, what differs from job to job, and the part that all jobs share.
#include "executor/job_script.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "executor/job_script_body.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

constexpr double end_margin_s = 60;  // for the command at the end: one pass of `rouleau sync`

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; });
}

void refuse_what_cannot_be_said(const std::filesystem::path& path) {
  const std::string& text = path.native();
  if (!has_control_character(text) && text.find('\\') == std::string::npos) return;
  fail(Exit::usage,
       "{}: holds a control character or a backslash, which a job script cannot name. Rename the directory.", text);
}

/// A key, token or name of ours: nothing that a shell, sbatch or a path takes for anything else.
bool is_plain(std::string_view word) {
  return !word.empty() && word.front() != '.' && word.front() != '-' &&
         std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-'; });
}

/// The words of an option line may hold what sbatch makes of them, but no further line.
void append_option(std::string& text, std::string_view option) {
  if (has_control_character(option)) {
    fail(Exit::usage, "sbatch = {}: holds a control character. Remove it from the cluster file.", option);
  }
  text += fmt::format("#SBATCH {}\n", option);
}

/// A path in an option line: sbatch takes %x as part of a pattern, and ends the word at a blank outside of quotes.
std::string for_sbatch(const std::filesystem::path& path) {
  std::string text;
  bool is_plain_path = true;
  for (const char c : path.native()) {
    if (c == '%') text += '%';
    if (c == '"') text += '\\';
    text += c;
    is_plain_path = is_plain_path && (std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                                      std::string_view("/._-+,:@%=").find(c) != std::string_view::npos);
  }
  return is_plain_path ? text : '"' + text + '"';
}

/// D-HH:MM:SS
std::string time_limit(double seconds) {
  const auto s = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}-{:02}:{:02}:{:02}", s / 86400, s / 3600 % 24, s / 60 % 60, s % 60);
}

long whole(double value) { return static_cast<long>(value); }

std::string options_of(const Cluster& cluster, const JobScript& job) {
  const ScriptPoint& first = job.points.front();
  const std::filesystem::path log =
      job.campaign / "points" / first.key / "attempts" / std::to_string(first.attempt) / "job.log";
  const long tasks = static_cast<long>(job.points.size()) * job.ranks;
  std::string text;
  append_option(text, fmt::format("--job-name={}", job.name));
  append_option(text, fmt::format("--output={}", for_sbatch(log)));
  append_option(text, "--open-mode=append");  // so that a second start does not wipe out what the first has said
  append_option(text, fmt::format("--time={}", time_limit(cluster.time_limit_s)));
  append_option(text, fmt::format("--nodes={}", std::min(whole(cluster.nodes), tasks)));
  append_option(text, fmt::format("--ntasks={}", tasks));
  if (cluster.memory_per_rank_MiB > 0) {
    append_option(text, fmt::format("--mem-per-cpu={}M", whole(cluster.memory_per_rank_MiB)));
  }
  if (!cluster.partition.empty()) append_option(text, "--partition=" + cluster.partition);
  if (!cluster.account.empty()) append_option(text, "--account=" + cluster.account);
  if (!cluster.qos.empty()) append_option(text, "--qos=" + cluster.qos);
  if (cluster.signal_s > 0) append_option(text, fmt::format("--signal=B:USR2@{}", whole(cluster.signal_s)));
  append_option(text, cluster.requeue > 0 ? "--requeue" : "--no-requeue");
  for (const std::string& option : cluster.sbatch) append_option(text, option);
  return text;
}

/// What stands in front of the solver's name.
std::vector<std::string> launcher_of(const Cluster& cluster, const JobScript& job) {
  const std::string ranks = std::to_string(job.ranks);
  const bool is_pack = job.points.size() > 1;
  if (cluster.launcher == "mpirun") {
    if (job.ranks == 1) return {};
    // Several mpirun in one job know nothing of each other and would bind their ranks to the same cores.
    if (is_pack) return {"mpirun", "-n", ranks, "--bind-to", "none"};
    return {"mpirun", "-n", ranks};
  }
  std::vector<std::string> launcher = {"srun"};
  if (!cluster.mpi.empty()) launcher.push_back("--mpi=" + cluster.mpi);
  // Each step of a pack takes the cores of its ranks and leaves the others to its neighbours.
  launcher.insert(launcher.end(), {"--exact", "-n", ranks});
  // A rank that dies must not leave the others waiting for its messages until the time limit.
  if (job.ranks > 1) launcher.emplace_back("--wait=60");
  // Without a figure the first step would take all memory of the job, and the others would wait for its end.
  if (is_pack && cluster.memory_per_rank_MiB == 0) launcher.emplace_back("--mem=0");
  return launcher;
}

std::string quoted_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_quoted(word);
  return text;
}

std::string settings_of(const Cluster& cluster, const JobScript& job) {
  std::string text;
  text += fmt::format("campaign={}\n", shell_quoted(job.campaign.native()));
  text += fmt::format("solver={}\n", shell_quoted(job.solver.native()));
  text += fmt::format("name={}\n", shell_quoted(job.name));
  text += fmt::format("launcher=({})\n", quoted_words(launcher_of(cluster, job)));
  text += fmt::format("at_end=({})\n", quoted_words(job.at_end));
  text += fmt::format("limit_s={}\n", whole(cluster.time_limit_s));
  text += fmt::format("margin_s={}\n", job.at_end.empty() ? 0 : whole(end_margin_s));
  std::vector<std::string> keys, attempts, tokens;
  for (const ScriptPoint& point : job.points) {
    keys.push_back(point.key);
    attempts.push_back(std::to_string(point.attempt));
    tokens.push_back(point.token);
  }
  text += fmt::format("keys=({})\nattempts=({})\ntokens=({})\n", quoted_words(keys), quoted_words(attempts),
                      quoted_words(tokens));
  return text;
}

void check(const JobScript& job) {
  require(!job.points.empty() && job.ranks >= 1, "a job has a point and a rank");
  require(job.solver.is_absolute() && job.campaign.is_absolute(), "a job script names absolute paths");
  require(is_plain(job.name), "a job's name is a plain word");
  for (const ScriptPoint& point : job.points) {
    require(is_plain(point.key) && is_plain(point.token) && point.attempt >= 1, "a point's key and token are plain");
  }
  refuse_what_cannot_be_said(job.solver);
  refuse_what_cannot_be_said(job.campaign);
  for (const std::string& word : job.at_end) refuse_what_cannot_be_said(word);
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  const bool needs_none = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("/._-+,:@%=").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (needs_none) return text;
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string job_script(const Cluster& cluster, const JobScript& job) {
  check(job);
  std::string text = "#!/bin/bash\n" + options_of(cluster, job);
  text += fmt::format("\ncd {} || exit 1\n", shell_quoted(job.campaign.native()));
  if (!cluster.setup.empty()) text += "\n# setup of the cluster file\n";
  for (const std::string& line : cluster.setup) {
    if (line.find_first_of(std::string_view("\n\0", 2)) != std::string::npos) {
      fail(Exit::usage, "setup = {}: holds a line end. Give each line a `setup` of its own.", line);
    }
    text += line + "\n";
  }
  return text + "\n" + settings_of(cluster, job) + std::string(job_script_body);
}

}  // namespace rouleau::campaign
