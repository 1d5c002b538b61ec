// SPDX-License-Identifier: BSD-3-Clause
// Reading a cluster file, and the table that reads, checks and documents its keys.
#include "study/cluster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>

#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/nearest.hpp"
#include "study/numbers.hpp"
#include "study/settings.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr std::size_t largest_cluster_file = std::size_t{1} << 16;  // bytes
constexpr double minute_s = 60;
constexpr double day_s = 86400;
constexpr double longest_limit_s = 366 * day_s;
constexpr double most_tasks = 1000000;  // of a job; more is a slip of the keyboard

constexpr SettingRow<Cluster> number_table[] = {
    {"points_per_job", &Cluster::points_per_job, 1, 10000, true, "points that one job runs side by side"},
    {"nodes", &Cluster::nodes, 1, 10000, true, "nodes of a job"},
    {"ranks", &Cluster::ranks, 0, 100000, true, "MPI ranks of a point; 0 = as [execution] of the study says"},
    {"memory_per_rank_MiB", &Cluster::memory_per_rank_MiB, 0, 1e7, true, "0 = Slurm's default"},
    {"jobs", &Cluster::jobs, 1, 100000, true, "jobs queued and running at a time"},
    {"submissions_per_pass", &Cluster::submissions_per_pass, 1, 10000, true, "jobs submitted in one pass"},
    {"poll_s", &Cluster::poll_s, 1, 86400, false, "between two looks at the queue"},
    {"patience_min", &Cluster::patience_min, 1, 10000, false,
     "a job that Slurm does not know and that has been silent for so long is lost"},
    {"client_timeout_s", &Cluster::client_timeout_s, 1, 3600, false,
     "of one call of sbatch, squeue, scontrol, scancel"},
    {"signal_s", &Cluster::signal_s, 0, 65535, true, "SIGUSR2 so long before the time limit; 0 = none"},
    {"requeue", &Cluster::requeue, 0, 1, true, "1 = Slurm may start a job again after a node failure or a preemption"},
};

/// A key whose value is one word, handed on to Slurm.
struct WordRow {
  std::string_view name;
  std::string Cluster::*member;
  std::string_view help;
};

constexpr WordRow word_table[] = {
    {"partition", &Cluster::partition, "where to queue; left out = Slurm's default"},
    {"account", &Cluster::account, "who pays; left out = Slurm's default"},
    {"qos", &Cluster::qos, "quality of service; left out = Slurm's default"},
    {"launcher", &Cluster::launcher, "srun or mpirun: what starts the ranks"},
    {"mpi", &Cluster::mpi, "of srun --mpi; default = the option is not given"},
};

/// A key that may be given several times.
struct LineRow {
  std::string_view name;
  std::vector<std::string> Cluster::*member;
  std::string_view help;
};

constexpr LineRow line_table[] = {
    {"sbatch", &Cluster::sbatch, "another option of sbatch, such as --exclusive; may be given several times"},
    {"setup", &Cluster::setup, "a line of shell code before the solver starts; may be given several times"},
};

/// An option of sbatch that a job needs as we set it.
struct OwnOption {
  std::string_view name;
  char letter;  ///< of its short form; 0 = none
  std::string_view instead;
};

constexpr std::string_view is_set = "rouleau sets it itself";

constexpr OwnOption own_options[] = {
    {"partition", 'p', "write partition = ..."},
    {"account", 'A', "write account = ..."},
    {"qos", 'q', "write qos = ..."},
    {"time", 't', "write time_limit = ..."},
    {"nodes", 'N', "write nodes = ..."},
    {"ntasks", 'n', "write ranks = ... and points_per_job = ..."},
    {"mem", 0, "write memory_per_rank_MiB = ..."},
    {"mem-per-cpu", 0, "write memory_per_rank_MiB = ..."},
    {"signal", 0, "write signal_s = ..."},
    {"requeue", 0, "write requeue = 1"},
    {"no-requeue", 0, "write requeue = 0"},
    {"array", 'a', "rouleau submits single jobs; write points_per_job = ... for packs"},
    {"clusters", 'M', "jobs of other clusters cannot be followed; run rouleau where the jobs run"},
    {"job-name", 'J', is_set},
    {"output", 'o', is_set},
    {"error", 'e', is_set},
    {"open-mode", 0, is_set},
    {"chdir", 'D', is_set},
    {"hold", 'H', is_set},
    {"parsable", 0, is_set},
    {"wait", 'W', "rouleau does not wait for jobs"},
    {"wrap", 0, "rouleau writes the script itself"},
    {"test-only", 0, "`rouleau engine check` tries the cluster"},
};

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\t') || c == 127; });
}

/// Fills a Cluster line by line; every error names file and line.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  Cluster read(const std::string& text) {
    std::istringstream lines(text);
    std::string raw;
    for (int line = 1; std::getline(lines, raw); ++line) read_line(raw, line);
    check_whole();
    return std::move(cluster_);
  }

 private:
  template <class... Args>
  [[noreturn]] void fail_at(int line, fmt::format_string<Args...> format, Args&&... args) const {
    fail(Exit::usage, "{}:{}: {}", file_, line, fmt::format(format, std::forward<Args>(args)...));
  }

  void read_line(const std::string& raw, int line) {
    const std::string bare = trimmed(raw.substr(0, raw.find('#')));
    if (bare.empty()) return;
    if (bare.front() == '[') {
      if (bare != "[cluster]") fail_at(line, "`{}` is no section of a cluster file. Write [cluster], or none.", bare);
      return;
    }
    const std::size_t equals = bare.find('=');
    if (equals == std::string::npos) fail_at(line, "`{}` is not name = value. Comments begin with #.", bare);
    const std::string name = trimmed(bare.substr(0, equals));
    if (name.empty()) fail_at(line, "there is no name in front of `=`.");
    // A # is part of the shell code in a setup line, which has its own comments.
    const std::string value = trimmed(name == "setup" ? raw.substr(raw.find('=') + 1) : bare.substr(equals + 1));
    if (value.empty()) fail_at(line, "`{}` has no value. Give one, or remove the line.", name);
    if (has_control_character(value)) fail_at(line, "the value of `{}` holds a control character. Remove it.", name);
    read_entry(name, value, line);
  }

  void read_entry(const std::string& name, const std::string& value, int line) {
    for (const LineRow& row : line_table) {
      if (row.name != name) continue;
      if (row.member == &Cluster::sbatch) check_option(value, line);
      (cluster_.*row.member).push_back(value);
      return;
    }
    const auto [before, is_new] = lines_.emplace(name, line);
    if (!is_new) fail_at(line, "`{}` was given in line {} already. Keep one of the two.", name, before->second);
    if (name == "time_limit") return read_time_limit(value, line);
    for (const WordRow& row : word_table) {
      if (row.name == name) return read_word(row, value, line);
    }
    for (const SettingRow<Cluster>& row : number_table) {
      if (row.name == name) return read_number(row, value, line);
    }
    fail_at(line, "`{}` is no key of a cluster file; it has {}.{}", name, fmt::format("{}", fmt::join(names(), ", ")),
            did_you_mean(name, names()));
  }

  static std::vector<std::string> names() {
    std::vector<std::string> all = {"time_limit"};
    for (const WordRow& row : word_table) all.emplace_back(row.name);
    for (const SettingRow<Cluster>& row : number_table) all.emplace_back(row.name);
    for (const LineRow& row : line_table) all.emplace_back(row.name);
    return all;
  }

  void read_time_limit(const std::string& value, int line) {
    cluster_.time_limit_s = seconds_of_time_limit(value);
    if (cluster_.time_limit_s < 0) {
      fail_at(line, "time_limit = {} is no time. Write it as for sbatch: 90 (minutes), 24:00:00 or 2-00:00:00.", value);
    }
    if (cluster_.time_limit_s < minute_s || cluster_.time_limit_s > longest_limit_s) {
      fail_at(line, "time_limit = {} is {} s; give one from a minute to 366 days.", value,
              shortest(cluster_.time_limit_s));
    }
  }

  void read_word(const WordRow& row, const std::string& value, int line) {
    const bool is_plain = std::all_of(value.begin(), value.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || std::string_view("_-.,:@+/").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (!is_plain || value.front() == '-') {
      fail_at(line, "{} = {} is no name that Slurm knows: letters, digits and _ - . , : @ + / are taken.", row.name,
              value);
    }
    if (row.member == &Cluster::launcher && value != "srun" && value != "mpirun") {
      const std::vector<std::string> launchers = {"srun", "mpirun"};
      fail_at(line, "launcher = {} is neither srun nor mpirun.{}", value, did_you_mean(value, launchers));
    }
    const bool is_default = row.member == &Cluster::mpi && value == "default";
    cluster_.*row.member = is_default ? "" : value;
  }

  void read_number(const SettingRow<Cluster>& row, const std::string& text, int line) {
    const std::optional<double> value = parse_number(text);
    if (!value) fail_at(line, "{} = {} is not a number.", row.name, text);
    if (*value < row.minimum || *value > row.maximum || (row.whole && *value != std::floor(*value))) {
      fail_at(line, "{} = {} is out of range. Give a {}number from {} to {}.", row.name, text,
              row.whole ? "whole " : "", shortest(row.minimum), shortest(row.maximum));
    }
    cluster_.*row.member = *value;
  }

  void check_option(const std::string& value, int line) const {
    if (value.front() != '-') {
      fail_at(line, "sbatch = {} does not begin with `-`. Give an option as sbatch takes it, such as --exclusive.",
              value);
    }
    std::istringstream words(value);
    std::string word;
    while (words >> word) {
      if (const OwnOption* own = own_option(word)) {
        fail_at(line, "sbatch = {} is not taken: {}.", word, own->instead);
      }
    }
  }

  static const OwnOption* own_option(std::string_view word) {
    for (const OwnOption& own : own_options) {
      if (word.starts_with("--")) {
        // sbatch takes an unmistakable beginning of an option's name for the whole.
        const std::string_view name = word.substr(2, word.find('=') - 2);
        if (!name.empty() && own.name.starts_with(name)) return &own;
      } else if (word.size() > 1 && word[0] == '-' && own.letter != 0 && word[1] == own.letter) {
        return &own;
      }
    }
    return nullptr;
  }

  /// The line of a key that is known to have been given.
  [[nodiscard]] int line_of(const std::string& name) const { return lines_.at(name); }

  void check_whole() const {
    const Cluster& c = cluster_;
    if (c.time_limit_s == 0) fail(Exit::usage, "{}: has no time limit. Add time_limit = 24:00:00, say.", file_);
    if (c.signal_s >= c.time_limit_s) {
      fail_at(lines_.count("signal_s") != 0 ? line_of("signal_s") : line_of("time_limit"),
              "signal_s = {} is no less than the time limit of {} s. Lower it.", shortest(c.signal_s),
              shortest(c.time_limit_s));
    }
    if (c.points_per_job > 1 && c.nodes > 1 && c.launcher == "mpirun") {
      fail_at(line_of("nodes"),
              "nodes = {} with points_per_job = {}: mpirun would start all points of a pack on the first node. Take "
              "nodes = 1, or launcher = srun.",
              shortest(c.nodes), shortest(c.points_per_job));
    }
    if (c.points_per_job * std::max(1.0, c.ranks) > most_tasks) {
      fail_at(line_of("points_per_job"), "points_per_job = {} with ranks = {} are more than {} tasks in a job.",
              shortest(c.points_per_job), shortest(c.ranks), shortest(most_tasks));
    }
  }

  Cluster cluster_;
  std::string file_;
  std::map<std::string, int> lines_;
};

/// The digits of a part of a time, or nothing.
std::optional<double> whole(const std::string& text) {
  const bool has_digits_only =
      !text.empty() && text.size() <= 9 && text.find_first_not_of("0123456789") == std::string::npos;
  return has_digits_only ? parse_number(text) : std::nullopt;
}

}  // namespace

double seconds_of_time_limit(const std::string& text) {
  constexpr double no_time = -1;
  const std::size_t dash = text.find('-');
  const bool has_days = dash != std::string::npos;
  const std::optional<double> days = has_days ? whole(text.substr(0, dash)) : 0;
  const std::vector<std::string> parts = split(has_days ? text.substr(dash + 1) : text, ':');
  if (!days || parts.size() > 3) return no_time;
  std::vector<double> values;
  for (const std::string& part : parts) {
    const std::optional<double> value = whole(part);
    if (!value) return no_time;
    values.push_back(*value);
  }
  // Behind days the first part is hours; without, one part is minutes, two are minutes and seconds.
  constexpr std::array<double, 3> units = {3600, minute_s, 1};
  const std::size_t first = has_days || values.size() == 3 ? 0 : 1;
  double seconds = *days * day_s;
  for (std::size_t i = 0; i < values.size(); ++i) seconds += values[i] * units[first + i];
  return seconds;
}

Cluster parse_cluster(const std::string& text, const std::filesystem::path& source) {
  return Reader(source.filename().string()).read(text);
}

Cluster read_cluster(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    fail(Exit::usage, "{}: is a directory. Name the cluster file, such as {}.", file.string(),
         (file / "cluster.ini").string());
  }
  const std::optional<std::string> text = read_whole_file(file, largest_cluster_file);
  if (!text) {
    fail(Exit::not_found,
         "{}: there is no such cluster file. `rouleau engine --help-cluster` shows how one is written.", file.string());
  }
  return parse_cluster(*text, file);
}

std::string cluster_help() {
  const Cluster defaults;
  std::string text =
      "A cluster file is text of `name = value` lines with # comments: what to ask of Slurm, and how a job is set up.\n"
      "It may be changed at any time; what is submitted later follows it. It must give time_limit.\n\n"
      "    time_limit           = 24:00:00 # of a job, as for sbatch: 90 (minutes), 24:00:00, 2-00:00:00\n";
  const auto line = [&](std::string_view name, std::string_view value, std::string_view help) {
    text += fmt::format("    {:<20} = {:<8} # {}", name, value, help);
  };
  for (const WordRow& row : word_table) {
    line(row.name, defaults.*row.member, row.help);
    text += '\n';
  }
  for (const SettingRow<Cluster>& row : number_table) {
    line(row.name, shortest(defaults.*row.member), row.help);
    text += fmt::format(" [{} ... {}]\n", shortest(row.minimum), shortest(row.maximum));
  }
  for (const LineRow& row : line_table) {
    line(row.name, "", row.help);
    text += '\n';
  }
  return text;
}

}  // namespace rouleau::campaign
