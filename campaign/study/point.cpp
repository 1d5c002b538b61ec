// SPDX-License-Identifier: BSD-3-Clause
// point.json: written for programs and people, read back without loss.
#include "study/point.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/error.hpp"
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

Point from_json(const Json& json) {
  Point point;
  json.at("key").get_to(point.key);
  json.at("identity").get_to(point.identity);
  json.at("ordinal").get_to(point.ordinal);
  json.at("replica").get_to(point.replica);
  json.at("in_study").get_to(point.in_study);
  json.at("cancelled").get_to(point.cancelled);
  json.at("retried_after").get_to(point.retried_after);
  json.at("swept").get_to(point.swept);
  RunFacts& facts = point.facts;
  json.at("steps").get_to(facts.steps);
  json.at("time_step_us").get_to(facts.time_step_us);
  json.at("end_time_s").get_to(facts.end_time_s);
  json.at("nodes").get_to(facts.nodes);
  json.at("samples").get_to(facts.samples);
  json.at("checkpoint_bytes").get_to(facts.checkpoint_bytes);
  json.at("snapshot_bytes").get_to(facts.snapshot_bytes);
  json.at("relative_cost_per_step").get_to(facts.relative_cost_per_step);
  for (const Json& entry : json.at("parameters")) {
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
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) fail(Exit::damaged, "{}: is missing. `rouleau init STUDY DIR` writes it anew.", file.string());
  try {
    return from_json(Json::parse(*text));
  } catch (const Json::exception& error) {
    fail(Exit::damaged, "{}: is damaged ({}). `rouleau init STUDY DIR` writes it anew.", file.string(), error.what());
  }
}

void write_point(const std::filesystem::path& file, const Point& point) {
  write_whole_file(file, to_json(point).dump(2) + "\n");
}

std::filesystem::path point_directory(const std::filesystem::path& campaign, const std::string& key) {
  return campaign / "points" / key;
}

}  // namespace rouleau::campaign
