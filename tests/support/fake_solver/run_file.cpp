// SPDX-License-Identifier: BSD-3-Clause
// Reading the run file.
#include "run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace fake {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool to_number(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() && *end == '/') {
    char* behind = nullptr;
    const double bottom = std::strtod(end + 1, &behind);
    if (behind == end + 1 || bottom == 0) return false;
    value /= bottom;
    end = behind;
  }
  return end != text.c_str() && *end == '\0' && std::isfinite(value);
}

std::string canonical(const Parameter& parameter, const std::string& text, const std::string& place) {
  if (!parameter.is_number) return text;
  double value = 0;
  if (!to_number(text, value)) throw Failure(65, place + parameter.name + " = " + text + " is not a number.");
  if (parameter.name == std::string("fluid.lambda") && (value < 0.1 || value > 100)) {
    throw Failure(65, place + "fluid.lambda = " + text + " is out of range. Give a number from 0.1 to 100.");
  }
  return fmt::format("{}", value);
}

}  // namespace

const std::vector<Parameter>& parameter_table() {
  static const std::vector<Parameter> table = {
      {"fluid.lambda", "5", true, true},
      {"fluid.plasma_viscosity_mPa_s", "1.2", true, true},
      {"channel.length_x_um", "", true, true},
      {"cell.shape", "red_blood_cell", true, false},
      {"cell.mesh_file", "none", true, false},
      {"cell.jitter_um", "0", true, true},
      {"cell.replica", "0", true, true},
      {"numerics.time_step_us", "", true, true},
      {"time.end_time_s", "", false, true},
      {"output.sample_interval_steps", "10", false, true},
      {"output.checkpoint_interval_min", "10", false, true},
      {"output.checkpoints_kept", "3", false, true},
  };
  return table;
}

std::string RunFile::text(const std::string& name) const {
  const auto found = given.find(name);
  if (found != given.end()) return found->second;
  const auto& table = parameter_table();
  return std::find_if(table.begin(), table.end(), [&](const Parameter& p) { return p.name == name; })->standard;
}

double RunFile::number(const std::string& name) const {
  double value = 0;
  to_number(text(name), value);
  return value;
}

long long RunFile::steps() const {
  return std::llround(number("time.end_time_s") * 1e6 / number("numerics.time_step_us"));
}

RunFile read_run_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw Failure(65, file + ": cannot be read.");
  RunFile run;
  std::string raw, section;
  for (int number = 1; std::getline(in, raw); ++number) {
    const std::string line = trimmed(raw.substr(0, raw.find('#')));
    const std::string place = "run.ini:" + std::to_string(number) + ": ";
    if (line.empty()) continue;
    if (line.front() == '[') {
      section = trimmed(line.substr(1, line.size() - 2));
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) throw Failure(65, place + "neither section nor entry.");
    const std::string name = section + "." + trimmed(line.substr(0, equals));
    const auto& table = parameter_table();
    const auto known = std::find_if(table.begin(), table.end(), [&](const Parameter& p) { return p.name == name; });
    if (known == table.end()) throw Failure(65, place + "unknown parameter " + name + ".");
    if (run.given.contains(name)) throw Failure(65, place + name + " is given twice.");
    run.given[name] = canonical(*known, trimmed(line.substr(equals + 1)), place);
  }
  for (const Parameter& parameter : parameter_table()) {
    if (*parameter.standard == '\0' && !run.given.contains(parameter.name)) {
      throw Failure(65, "run.ini: " + std::string(parameter.name) + " is missing.");
    }
  }
  return run;
}

}  // namespace fake
