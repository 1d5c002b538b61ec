// SPDX-License-Identifier: BSD-3-Clause
// `rouleau engine list | check`: which engines there are, and whether a cluster would do.
#include <chrono>
#include <cmath>
#include <ostream>
#include <sstream>

#include "commands/engine_trial.hpp"
#include "commands/verbs.hpp"
#include "executor/attempt.hpp"
#include "executor/capture.hpp"
#include "executor/job_script.hpp"
#include "executor/slurm.hpp"
#include "executor/solver.hpp"
#include "study/nearest.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

constexpr double most_clock_skew_s = 5;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("dir,C", po::value<std::string>()->value_name("DIR"), "the campaign's directory (default: the current one)");
  add("cluster", po::value<std::string>()->value_name("FILE"), "the cluster file (default: DIR/cluster.ini)");
  add("wait-s", po::value<double>()->value_name("S")->default_value(300), "for the small job, before it is cancelled");
  add("no-job", po::bool_switch(), "submit nothing: only ask");
  add("help-cluster", po::bool_switch(), "how a cluster file is written, with every key");
}

/// One line a check; remembers the worst.
class Report {
 public:
  explicit Report(std::ostream& out) : out_(out) {}
  void ok(std::string_view what, std::string_view words) { line("ok", what, words); }
  void warn(std::string_view what, std::string_view words) { line("warning", what, words); }
  void failed(std::string_view what, std::string_view words) {
    line("FAILED", what, words);
    if (outcome_ == Exit::ok) outcome_ = Exit::failed;
  }
  void unreachable(std::string_view what, std::string_view words) {
    line("FAILED", what, words);
    outcome_ = Exit::engine_unreachable;
  }
  void interrupted() { outcome_ = Exit::interrupted; }
  [[nodiscard]] Exit outcome() const { return outcome_; }

 private:
  void line(std::string_view verdict, std::string_view what, std::string_view words) {
    out_ << fmt::format("{:<7}  {:<16} {}", verdict, what, words) << std::endl;
  }

  std::ostream& out_;
  Exit outcome_ = Exit::ok;
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

Capture ask(const std::vector<std::string>& command, double time_out_s) {
  return run_and_capture(
      command, CaptureSettings{.directory = {}, .time_out_s = time_out_s, .environment = environment_without_slurm()});
}

bool check_commands(Report& report, double time_out_s) {
  bool all = true;
  for (const char* program : {"sbatch", "squeue", "scontrol", "scancel"}) {
    try {
      const Capture answer = ask({program, "--version"}, time_out_s);
      if (answer.status == 0) {
        report.ok(program, first_line(answer.out));
        continue;
      }
      if (answer.timed_out) {
        report.unreachable(program, fmt::format("gave no answer within {} s: {} Try again later.", time_out_s,
                                                first_line(answer.err)));
        return false;
      }
      report.failed(program, fmt::format("ended with status {}: {} Try `{} --version` by hand.", answer.status,
                                         first_line(answer.err), program));
    } catch (const Error& error) {
      report.failed(program, fmt::format("{} Load Slurm's module, or go to a login node.", error.what()));
    }
    all = false;
  }
  return all;
}

bool check_controller(Report& report, const Slurm& slurm) {
  const auto start = std::chrono::steady_clock::now();
  const JobList jobs = slurm.jobs();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!jobs.answered) {
    report.unreachable("controller", jobs.trouble + ". Try again later, or ask those who run the cluster.");
    return false;
  }
  report.ok("controller", fmt::format("answers within {:.2f} s; it knows {} jobs of yours", seconds, jobs.rows.size()));
  return true;
}

/// The value of NAME=... in a line of `scontrol -o show`.
std::string value_of(const std::string& line, const std::string& name) {
  const std::size_t begin = (" " + line).find(" " + name + "=");
  if (begin == std::string::npos) return "";
  const std::size_t value = begin + name.size() + 1;
  return line.substr(value, line.find(' ', value) - value);
}

/// Slurm takes a job beyond the partition's time limit and lets it wait for ever, unless it is told otherwise.
void check_time_limit(Report& report, const Cluster& cluster) {
  const Capture answer = ask({"scontrol", "-o", "show", "partition"}, cluster.client_timeout_s);
  std::istringstream lines(answer.out);
  std::string line;
  while (std::getline(lines, line)) {
    const std::string name = value_of(line, "PartitionName");
    const bool is_ours = cluster.partition.empty() ? value_of(line, "Default") == "YES" : name == cluster.partition;
    if (!is_ours) continue;
    const std::string most = value_of(line, "MaxTime");
    const double most_s = seconds_of_time_limit(most);
    if (most_s >= 0 && cluster.time_limit_s > most_s) {
      report.failed("time limit", fmt::format("{} s are more than the {} of partition {}. Lower time_limit.",
                                              shortest(cluster.time_limit_s), most, name));
    } else {
      report.ok("time limit", fmt::format("{} s; partition {} allows {}", shortest(cluster.time_limit_s), name, most));
    }
    if (const std::string state = value_of(line, "State"); state != "UP") {
      report.warn("partition", fmt::format("{} is {}: jobs will wait until it is UP", name, state));
    }
    return;
  }
}

/// Whether Slurm would take a job of full size.
void check_request(Report& report, const Cluster& cluster, const std::filesystem::path& solver,
                   const std::filesystem::path& directory) {
  JobScript job{.solver = solver,
                .campaign = directory,
                .name = "rouleau-check",
                .ranks = std::max(1, static_cast<int>(cluster.ranks)),
                .points = {},
                .at_end = {}};
  for (int i = 0; i < static_cast<int>(cluster.points_per_job); ++i) {
    job.points.push_back({fmt::format("point-{}", i), 1, "token"});
  }
  const ScratchDirectory scratch;
  const std::filesystem::path script = scratch.path() / "job.sh";
  write_whole_file(script, job_script(cluster, job));
  const Submission answer = Slurm(cluster.client_timeout_s).test_only(script);
  if (!answer.id.empty()) {
    report.ok("request", answer.words);
  } else if (answer.transient) {
    report.unreachable("request", answer.trouble + ". Try again later.");
  } else {
    report.failed("request",
                  answer.trouble +
                      ". Correct partition, account, qos, time_limit, nodes, points_per_job or sbatch in the "
                      "cluster file; `sinfo` and `scontrol show partition` say what there is.");
  }
}

void report_clock(Report& report, const Trial& trial) {
  if (!trial.clock_ahead_s) {
    report.failed(
        "shared directory",
        fmt::format("{} did not see what was written here. Do the nodes mount it read-only, or late?", trial.node));
    return;
  }
  const std::string words = fmt::format("that of {} is {:.1f} s {} ours", trial.node, std::abs(*trial.clock_ahead_s),
                                        *trial.clock_ahead_s < 0 ? "behind" : "ahead of");
  if (std::abs(*trial.clock_ahead_s) > most_clock_skew_s) {
    report.warn("clock", words + ". Times in listings will be off by that; tell those who run the cluster.");
  } else if (*trial.clock_ahead_s == 0) {
    report.ok("clock", fmt::format("that of {} agrees with ours, as far as files can tell", trial.node));
  } else {
    report.ok("clock", words);
  }
}

void report_mpi(Report& report, const Trial& trial, const Cluster& cluster) {
  const std::string how =
      cluster.launcher + (cluster.launcher == "srun" && !cluster.mpi.empty() ? " --mpi=" + cluster.mpi : std::string());
  const char* advice =
      ". Load in a setup line the MPI that rouleau-solver was built with, and try another `mpi` (`srun --mpi=list`) or "
      "launcher = mpirun in the cluster file.";
  if (trial.code == 0 && trial.ranks == 2) {
    report.ok("MPI", fmt::format("rouleau-solver ran on 2 ranks by {} on {}", how, trial.node));
  } else if (trial.code == 0) {
    report.failed("MPI", fmt::format("of two ranks by {}, each ran alone{}", how, advice));
  } else {
    std::string words = trial.last_words.empty() ? "it said nothing" : trial.last_words;
    while (words.ends_with('.')) words.pop_back();
    const std::string end = trial.code ? fmt::format("with code {}", *trial.code) : "without a record of its end";
    report.failed("MPI", fmt::format("rouleau-solver on 2 ranks by {} ended {}: {}{}", how, end, words, advice));
  }
}

void check_by_job(Report& report, const CommandLine& line, const Cluster& cluster, const TrialOrder& order) {
  const Trial trial = try_cluster(cluster, order, [&](const std::string& text) {
    if (!line.quiet) line.io.err << text << std::endl;
  });
  if (trial.interrupted) {
    report.failed("job", trial.trouble);
    return report.interrupted();
  }
  if (!trial.submitted && !trial.answers) return report.unreachable("job", trial.trouble + ". Try again later.");
  if (!trial.node.empty()) {
    report.ok("shared directory",
              fmt::format("{}: seen from {} after {:.1f} s", order.directory.string(), trial.node, trial.seen_after_s));
  }
  if (!trial.trouble.empty()) {
    const std::string words = trial.last_words.empty() ? "" : fmt::format(" Its last words: {}", trial.last_words);
    return report.failed("job", trial.trouble + "." + words);
  }
  if (trial.node.empty()) return report.failed("job", "ended before its setup lines did: " + trial.last_words);
  report_clock(report, trial);
  report_mpi(report, trial, cluster);
}

int check(const CommandLine& line) {
  const std::filesystem::path directory = std::filesystem::canonical(line.directory);
  if (!line.has("cluster") && !std::filesystem::exists(directory / "cluster.ini")) {
    fail(Exit::usage,
         "{}: has no cluster.ini. Name a cluster file by --cluster FILE; `rouleau engine --help-cluster` shows how one "
         "is written.",
         directory.string());
  }
  const std::filesystem::path file =
      line.has("cluster") ? std::filesystem::path(line.get<std::string>("cluster")) : directory / "cluster.ini";
  const double wait_s = line.get<double>("wait-s");
  if (!(wait_s > 0 && wait_s <= 1e6)) {
    fail(Exit::usage, "rouleau engine: --wait-s {} is out of range. Give seconds from 1 to 1e6.", shortest(wait_s));
  }
  const Cluster cluster = read_cluster(file);
  const std::filesystem::path solver = find_solver();

  Report report(line.io.out);
  report.ok("cluster file", file.string());
  if (check_commands(report, cluster.client_timeout_s) && check_controller(report, Slurm(cluster.client_timeout_s))) {
    check_request(report, cluster, solver, directory);
    if (report.outcome() != Exit::engine_unreachable) check_time_limit(report, cluster);
    if (report.outcome() == Exit::ok && !line.is_set("no-job")) {
      check_by_job(report, line, cluster, {.solver = solver, .directory = directory, .wait_s = wait_s});
    }
  }
  return static_cast<int>(report.outcome());
}

int engine(const CommandLine& line) {
  if (line.is_set("help-cluster")) {
    line.io.out << cluster_help();
    return static_cast<int>(Exit::ok);
  }
  const std::vector<std::string> acts = {"list", "check"};
  const std::string act = line.words.size() == 1 ? line.words.front() : "";
  if (act == "check") return check(line);
  if (act == "list") {
    line.io.out << "local  processes of this machine\n"
                   "slurm  jobs of a cluster; DIR/cluster.ini says how (`rouleau engine --help-cluster`)\n";
    return static_cast<int>(Exit::ok);
  }
  fail(Exit::usage, "rouleau engine: say `list` or `check`{}.{} `rouleau engine --help` explains.",
       line.words.empty() ? "" : fmt::format(", not `{}`", fmt::join(line.words, " ")), did_you_mean(act, acts));
}

}  // namespace

const Verb engine_verb = {
    "engine",
    "list the engines, or check that a cluster would do",
    "list | check [--cluster FILE] [--wait-s S] [--no-job] [-C DIR]",
    "  rouleau engine list                                      local and slurm\n"
    "  rouleau engine check --cluster small.ini                 before the first campaign on a cluster\n"
    "  rouleau engine check -C my-campaign                      with its own cluster.ini\n",
    "`check` asks Slurm's programs, its controller and the partition, then submits one job of two ranks and two\n"
    "minutes at most in a folder of DIR, and shows whether a node sees DIR, whether MPI starts, and whether the "
    "clocks\n"
    "agree. One line a check: ok, warning, or FAILED with what to do.\n",
    Words::free,
    false,
    describe,
    engine,
};

}  // namespace rouleau::campaign
