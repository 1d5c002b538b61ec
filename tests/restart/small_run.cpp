// SPDX-License-Identifier: BSD-3-Clause
#include "restart/small_run.hpp"

#include <fmt/format.h>

namespace rouleau::testing {

namespace {
constexpr double time_step_us = 1.25;
}

SmallRun::SmallRun(Changes changes)
    : values_{{"fluid.lambda", "5"},
              {"channel.length_x_um", "16"},
              {"channel.length_y_um", "12"},
              {"channel.length_z_um", "10"},
              {"flow.mean_velocity_mm_per_s", "1.5"},
              {"flow.initial", "developed"},
              {"cell.subdivisions", "3"},
              {"cell.position_x_um", "15"},
              {"cell.offset_y_um", "0.5"},
              {"cell.rotation_axis", "0 1 0"},
              {"cell.rotation_angle_deg", "40"},
              {"membrane.shear_modulus_uN_per_m", "5"},
              {"membrane.bending_modulus_J", "1e-18"},
              {"numerics.node_spacing_um", "2/3"},
              {"numerics.time_step_us", fmt::format("{}", time_step_us)},
              {"numerics.correction_interval", "7"},
              {"bounds.unsafe_combination", "run"},  // some tests take a kernel that would not hold for long
              {"output.sample_interval_steps", "10"},
              {"output.progress_interval_s", "1"}} {
  for (const auto& [name, value] : changes) values_[name] = value;
  set_steps(40);
}

void SmallRun::set(const std::string& name, const std::string& value) {
  values_[name] = value;
  write_run_file();
}

void SmallRun::set_steps(int steps) { set("time.end_time_s", fmt::format("{:.9f}", steps * time_step_us * 1e-6)); }

void SmallRun::write_run_file() const {
  std::string text, section;
  for (const auto& [name, value] : values_) {
    if (value.empty()) continue;
    const auto dot = name.rfind('.');
    if (name.substr(0, dot) != section) text += "[" + (section = name.substr(0, dot)) + "]\n";
    text += name.substr(dot + 1) + " = " + value + "\n";
  }
  set_content(path("run.ini"), text);
}

Finished SmallRun::run(int ranks, const std::vector<std::string>& options,
                       std::optional<Interruption> interruption) const {
  std::vector<std::string> words = launcher(ranks);
  words.insert(words.end(), {ROULEAU_SOLVER, path("run.ini").string(), "--quiet"});
  words.insert(words.end(), options.begin(), options.end());
  return run_program(words, interruption);
}

void SmallRun::finish(int ranks) const {
  const Finished finished = run(ranks);
  ASSERT_EQ(finished.code, 0) << finished.err;
}

nlohmann::json SmallRun::newest_checkpoint() const {
  std::filesystem::path newest;
  for (const auto& entry : std::filesystem::directory_iterator(path("checkpoints")))
    if (entry.path().extension() == ".h5") newest = std::max(newest, entry.path());
  const Finished inspected = run_program({ROULEAU_SOLVER, "inspect", newest.string(), "--format", "json"});
  EXPECT_EQ(inspected.code, 0) << inspected.err;
  return nlohmann::json::parse(inspected.out);
}

std::string SmallRun::fingerprint() const {
  return newest_checkpoint().at("digest").get<std::string>() + "\n" + samples();
}

nlohmann::json SmallRun::exit_record() const {
  int newest = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("attempts")))
    newest = std::max(newest, std::stoi(entry.path().filename().string()));
  return nlohmann::json::parse(content_of(path("attempts/" + std::to_string(newest) + "/exit.json")));
}

}  // namespace rouleau::testing
