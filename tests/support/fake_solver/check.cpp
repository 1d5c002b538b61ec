// SPDX-License-Identifier: BSD-3-Clause
// The check's answer.
#include "check.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace fake {

namespace {

std::string content_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Failure(65, "run.ini: the file " + file + " cannot be read.");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string identity_of(const RunFile& run) {
  std::string text;
  for (const Parameter& parameter : parameter_table()) {
    if (!parameter.is_identity || run.text(parameter.name) == parameter.standard) continue;
    const std::string value = run.text(parameter.name);
    const bool is_file = std::string(parameter.name).ends_with("_file");
    text += std::string(parameter.name) + "=" + (is_file ? content_of(value) : value) + "\n";
  }
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string check_json(const RunFile& run) {
  nlohmann::ordered_json parameters = nlohmann::json::array();
  for (const Parameter& parameter : parameter_table()) {
    parameters.push_back({{"name", parameter.name},
                          {"value", run.text(parameter.name)},
                          {"default", parameter.standard},
                          {"kind", parameter.is_identity ? "identity" : "free"},
                          {"given", run.given.contains(parameter.name)}});
  }
  const auto interval = static_cast<long long>(run.number("output.sample_interval_steps"));
  nlohmann::ordered_json warnings = nlohmann::json::array();
  if (run.number("fluid.lambda") > 50) warnings.push_back("fluid.lambda above 50 is doubtful.");
  const nlohmann::ordered_json json = {{"contract", 1},
                                       {"version", "0.0.1"},
                                       {"git", "fake"},
                                       {"parameters", parameters},
                                       {"identity", identity_of(run)},
                                       {"steps", run.steps()},
                                       {"time_step_us", run.number("numerics.time_step_us")},
                                       {"nodes", 1000},
                                       {"triangles", 320},
                                       {"vertices", 162},
                                       {"cells", 1},
                                       {"end_time_s", run.number("time.end_time_s")},
                                       {"samples", run.steps() / interval + 1},
                                       {"checkpoint_bytes", 1000},
                                       {"snapshot_bytes", 0},
                                       {"node_spacing_um", 0.5},
                                       {"relative_cost_per_step", 1000.0},
                                       {"warnings", warnings}};
  return json.dump();
}

}  // namespace fake
