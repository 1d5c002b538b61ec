// SPDX-License-Identifier: BSD-3-Clause
// Reading a study file: our own sections are checked here, run parameters are left to the solver.
#include "study/study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/nearest.hpp"
#include "study/numbers.hpp"
#include "study/sweep.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr std::size_t largest_study = std::size_t{1} << 20;  // bytes, as of a run file
constexpr std::size_t longest_name = 100;
const std::vector<std::string> own_sections = {"study", "sweep", "execution", "analysis"};
const std::vector<std::string> engines = {"local", "slurm"};

/// Fills a Study entry by entry; every error names file and line.
class Reader {
 public:
  Reader(Study& study, std::string file) : study_(study), file_(std::move(file)) {}

  void read(const std::vector<IniEntry>& entries) {
    for (const IniEntry& entry : entries) {
      if (entry.section == "study") {
        read_study_entry(entry);
      } else if (entry.section == "sweep") {
        read_sweep_entry(entry);
      } else if (entry.section == "execution") {
        read_execution_entry(entry);
      } else if (entry.section == "analysis") {
        read_setting(entry, analysis_rows(), study_.analysis, {});
      } else {
        read_run_parameter(entry);
      }
    }
    check_whole();
  }

 private:
  template <class... Args>
  [[noreturn]] void fail_at(int line, fmt::format_string<Args...> format, Args&&... args) const {
    fail(Exit::usage, "{}:{}: {}", file_, line, fmt::format(format, std::forward<Args>(args)...));
  }

  void read_study_entry(const IniEntry& entry) {
    const std::vector<std::string> names = {"name"};
    if (entry.name != "name") {
      fail_at(entry.line, "[study] knows no `{}`; it has `name` only.{}", entry.name, did_you_mean(entry.name, names));
    }
    const bool is_plain = std::all_of(entry.value.begin(), entry.value.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    });
    if (!is_plain) {
      fail_at(entry.line, "name = {} holds more than letters, digits, `_`, `-` and `.`. Choose a plain name.",
              entry.value);
    }
    if (entry.value.size() > longest_name)
      fail_at(entry.line, "the name has {} letters; at most {} are taken.", entry.value.size(), longest_name);
    study_.name = entry.value;
  }

  void read_sweep_entry(const IniEntry& entry) {
    if (entry.name == "mode") {
      if (entry.value != "product" && entry.value != "zip") {
        const std::vector<std::string> modes = {"product", "zip"};
        fail_at(entry.line, "mode = {} is neither product nor zip.{}", entry.value, did_you_mean(entry.value, modes));
      }
      study_.mode = entry.value == "zip" ? SweepMode::zip : SweepMode::product;
      mode_line_ = entry.line;
    } else if (entry.name == "replicas") {
      study_.replicas = static_cast<int>(number(entry, 1, 10000, true));
      replicas_line_ = entry.line;
    } else if (entry.name.find('.') == std::string::npos) {
      const std::vector<std::string> names = {"mode", "replicas"};
      fail_at(entry.line,
              "[sweep] knows no `{}`. An axis is written section.name, such as fluid.lambda = 1, 2, 4:5:0.25; besides "
              "there are mode and replicas.{}",
              entry.name, did_you_mean(entry.name, names));
    } else {
      study_.axes.push_back({entry.name, expand_values(entry.value, file_, entry.line), entry.line});
    }
  }

  void read_execution_entry(const IniEntry& entry) {
    if (entry.name == "engine") {
      if (std::find(engines.begin(), engines.end(), entry.value) == engines.end()) {
        fail_at(entry.line, "engine = {} is not known; there is: {}.{}", entry.value,
                fmt::format("{}", fmt::join(engines, ", ")), did_you_mean(entry.value, engines));
      }
      study_.execution.engine = entry.value;
    } else if (entry.name == "checkpoint_interval_min") {
      study_.fixed.push_back({"output.checkpoint_interval_min", entry.value, entry.line});
    } else {
      read_setting(entry, execution_rows(), study_.execution, {"engine", "checkpoint_interval_min"});
    }
  }

  template <class Settings>
  void read_setting(const IniEntry& entry, std::span<const SettingRow<Settings>> rows, Settings& settings,
                    std::vector<std::string> names) {
    for (const SettingRow<Settings>& row : rows) {
      if (row.name == entry.name) {
        settings.*row.member = number(entry, row.minimum, row.maximum, row.whole);
        return;
      }
      names.emplace_back(row.name);
    }
    std::string known = names.front();
    for (std::size_t i = 1; i < names.size(); ++i) known += ", " + names[i];
    fail_at(entry.line, "[{}] knows no `{}`; it has {}.{}", entry.section, entry.name, known,
            did_you_mean(entry.name, names));
  }

  void read_run_parameter(const IniEntry& entry) {
    // A section that is nearly ours is a typing error; all others are the solver's to judge.
    if (const std::string ours = nearest(entry.section, own_sections); !ours.empty()) {
      fail_at(entry.line, "`{}` stands in the unknown section [{}]. Did you mean [{}]?", entry.name, entry.section,
              ours);
    }
    const std::string name = entry.section + '.' + entry.name;
    study_.fixed.push_back({name, entry.value, entry.line});
  }

  double number(const IniEntry& entry, double minimum, double maximum, bool whole) const {
    const std::optional<double> value = parse_number(entry.value);
    if (!value) fail_at(entry.line, "{} = {} is not a number.", entry.name, entry.value);
    if (*value < minimum || *value > maximum || (whole && *value != std::floor(*value))) {
      fail_at(entry.line, "{} = {} is out of range. Give a {}number from {} to {}.", entry.name, entry.value,
              whole ? "whole " : "", shortest(minimum), shortest(maximum));
    }
    return *value;
  }

  void check_whole() const {
    if (study_.name.empty()) fail(Exit::usage, "{}: has no name. Add a section [study] with name = ...", file_);
    check_names_are_unique();
    check_replicas();
    if (study_.mode == SweepMode::zip && study_.axes.size() > 1) {
      const Axis& first = study_.axes.front();
      for (const Axis& axis : study_.axes) {
        if (axis.values.size() != first.values.size()) {
          fail_at(axis.line, "{} has {} values, but {} (line {}) has {}: with mode = zip (line {}) they must be equal.",
                  axis.name, axis.values.size(), first.name, first.line, first.values.size(), mode_line_);
        }
      }
    }
    if (const double count = count_of(study_); count > most_points) {
      fail(Exit::usage, "{}: the sweep has {:.0f} points; at most {} are taken. Shorten an axis.", file_, count,
           most_points);
    }
  }

  void check_names_are_unique() const {
    std::vector<Entry> all = study_.fixed;
    for (const Axis& axis : study_.axes) all.push_back({axis.name, "", axis.line});
    if (study_.replicas > 0) all.push_back({"cell.replica", "", replicas_line_});
    std::stable_sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) { return a.line < b.line; });
    std::map<std::string_view, int> lines;
    for (const Entry& entry : all) {
      const auto [before, is_new] = lines.emplace(entry.name, entry.line);
      if (is_new) continue;
      fail_at(entry.line, "{} was set in line {} already. A parameter is either fixed or an axis, once.", entry.name,
              before->second);
    }
  }

  void check_replicas() const {
    if (study_.replicas == 0) return;
    for (const Entry& entry : study_.fixed) {
      if (entry.name == "cell.jitter_um" && parse_number(entry.value).value_or(0) > 0) return;
    }
    for (const Axis& axis : study_.axes) {
      if (axis.name == "cell.jitter_um") return;
    }
    fail_at(replicas_line_,
            "replicas = {} would all start alike, because cell.jitter_um is 0. Set [cell] jitter_um above 0 (say 0.1).",
            study_.replicas);
  }

  Study& study_;
  std::string file_;
  int mode_line_ = 0;
  int replicas_line_ = 0;
};

}  // namespace

Study parse_study(const std::string& text, const std::filesystem::path& source) {
  Study study;
  study.text = text;
  study.source = source;
  Reader reader(study, study.file_name());
  reader.read(parse_ini(text, study.file_name()));
  return study;
}

Study read_study(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    fail(Exit::usage, "{}: is a directory. Name the study file, such as {}.", file.string(),
         (file / "study.ini").string());
  }
  const std::optional<std::string> text = read_whole_file(file, largest_study);
  if (!text) fail(Exit::not_found, "{}: there is no such study file.", file.string());
  return parse_study(*text, file);
}

}  // namespace rouleau::campaign
