// SPDX-License-Identifier: BSD-3-Clause
// point.json: written for programs and people, read back without loss.
#include "study/point.hpp"

#include <algorithm>

#include "study/error.hpp"
#include "study/record.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr int point_format = 1;

using Json = nlohmann::ordered_json;

Json to_json(const Point& point) {
  Json parameters = Json::array();
  for (const Parameter& parameter : point.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"value", parameter.value},
                          {"kind", parameter.is_identity ? "identity" : "free"},
                          {"given", parameter.is_given}});
  }
  const RunFacts& facts = point.facts;
  return {{"contract", point_format},
          {"key", point.key},
          {"identity", point.identity},
          {"ordinal", point.ordinal},
          {"replica", point.replica},
          {"in_study", point.in_study},
          {"cancelled", point.cancelled},
          {"retried_after", point.retried_after},
          {"run_file", point.run_file_digest},
          {"swept", point.swept},
          {"steps", facts.steps},
          {"time_step_us", facts.time_step_us},
          {"end_time_s", facts.end_time_s},
          {"nodes", facts.nodes},
          {"samples", facts.samples},
          {"checkpoint_bytes", facts.checkpoint_bytes},
          {"snapshot_bytes", facts.snapshot_bytes},
          {"relative_cost_per_step", facts.relative_cost_per_step},
          {"parameters", parameters}};
}

template <class T>
void take(const nlohmann::json& json, const char* name, T& value) {
  value = strictly<T>(json.at(name));
}

Point from_json(const nlohmann::json& json) {
  Point point;
  take(json, "key", point.key);
  take(json, "identity", point.identity);
  if (point.key.empty() || !is_hex(point.key)) throw Damage("its key is not of hex digits");
  take(json, "ordinal", point.ordinal);
  take(json, "replica", point.replica);
  take(json, "in_study", point.in_study);
  take(json, "cancelled", point.cancelled);
  take(json, "retried_after", point.retried_after);
  if (json.contains("run_file")) take(json, "run_file", point.run_file_digest);  // older ones have none
  take(json, "swept", point.swept);
  RunFacts& facts = point.facts;
  take(json, "steps", facts.steps);
  take(json, "time_step_us", facts.time_step_us);
  take(json, "end_time_s", facts.end_time_s);
  take(json, "nodes", facts.nodes);
  take(json, "samples", facts.samples);
  take(json, "checkpoint_bytes", facts.checkpoint_bytes);
  take(json, "snapshot_bytes", facts.snapshot_bytes);
  take(json, "relative_cost_per_step", facts.relative_cost_per_step);
  for (const nlohmann::json& entry : json.at("parameters")) {
    point.parameters.push_back(
        {entry.at("name"), entry.at("value"), entry.at("kind") == "identity", entry.at("given")});
  }
  return point;
}

}  // namespace

const std::string* Point::find(const std::string& name) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == parameters.end() ? nullptr : &found->value;
}

std::string Point::label() const {
  std::string text;
  for (const std::string& name : swept) {
    if (const std::string* value = find(name)) text += (text.empty() ? "" : ", ") + name + " = " + *value;
  }
  return text.empty() ? key : text;
}

Point read_point(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_whole_file(file, largest_record);
  if (!text) fail(Exit::damaged, "{}: is missing. `rouleau init STUDY DIR` writes it anew.", file.string());
  return read_record(*text, file, ". `rouleau init STUDY DIR` writes it anew.", from_json);
}

bool is_hex(const std::string& text) { return text.find_first_not_of("0123456789abcdef") == std::string::npos; }

void write_point(const std::filesystem::path& file, const Point& point) {
  write_whole_file(file, record_text(to_json(point)));
}

std::filesystem::path point_directory(const std::filesystem::path& campaign, const std::string& key) {
  return campaign / "points" / key;
}

}  // namespace rouleau::campaign
