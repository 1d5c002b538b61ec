// SPDX-License-Identifier: BSD-3-Clause
// The rows of a point as one JSON document.
#include "ingest/result_file.hpp"

#include <nlohmann/json.hpp>

#include "ingest/ingest.hpp"
#include "study/error.hpp"
#include "study/record.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const ResultRow& result) {
  return {{"cell", result.cell},
          {"window_s", result.window_s},
          {"window_start_s", result.window_start_s},
          {"time_s", result.time_s},
          {"step", result.step},
          {"samples", result.samples},
          {"d_mean_um", json_of(result.d_mean_um)},
          {"d_error_um", json_of(result.d_error_um)},
          {"d_change_um", json_of(result.d_change_um)},
          {"d_amplitude_um", json_of(result.d_amplitude_um)},
          {"d_period_s", json_of(result.d_period_s)},
          {"asphericity_mean", json_of(result.asphericity_mean)},
          {"asphericity_error", json_of(result.asphericity_error)},
          {"tank_treading_per_s", json_of(result.tank_treading_per_s)},
          {"tank_treading_error_per_s", json_of(result.tank_treading_error_per_s)},
          {"tank_treading_reason", result.tank_treading_reason},
          {"class", result.phase},
          {"class_reason", result.phase_reason},
          {"note", result.note}};
}

/// What all attempts together cost; attempts that were killed left no figures and are counted apart.
Json cost_of(const std::vector<AttemptRow>& attempts) {
  double wall_s = 0, core_s = 0, updates = 0, timed_s = 0;
  int without_figures = 0;
  for (const AttemptRow& attempt : attempts) {
    if (!attempt.wall_s || !attempt.core_s) {
      ++without_figures;
      continue;
    }
    wall_s += *attempt.wall_s;
    core_s += *attempt.core_s;
    if (attempt.mlups) {
      updates += *attempt.mlups * *attempt.wall_s;
      timed_s += *attempt.wall_s;
    }
  }
  return {{"attempts", attempts.size()},
          {"attempts_without_figures", without_figures},
          {"wall_s", wall_s},
          {"core_h", core_s / 3600},
          {"mlups", timed_s > 0 ? Json(updates / timed_s) : Json(nullptr)}};
}

}  // namespace

std::string result_json(const Store& store, std::string_view key) {
  const std::optional<PointRow> point = store.point(key);
  if (!point) fail(Exit::not_found, "{}: has no point {}", store.database().file().string(), key);
  const std::vector<AttemptRow> attempts = store.attempts(key);

  Json swept = Json::object();
  for (const ParameterRow& parameter : store.parameters(key))
    if (parameter.swept) swept[parameter.name] = parameter.text;
  Json thresholds = Json::object();
  const Analysis analysis = stored_analysis(store);
  for (const SettingRow<Analysis>& row : analysis_rows()) thresholds[std::string(row.name)] = analysis.*row.member;
  Json cells = Json::array();
  for (const ResultRow& result : store.results(key)) cells.push_back(json_of(result));
  Json runs = Json::array();
  for (const AttemptRow& attempt : attempts)
    runs.push_back({{"attempt", attempt.number},
                    {"host", attempt.host},
                    {"ranks", attempt.ranks},
                    {"start_step", json_of(attempt.start_step)},
                    {"step", json_of(attempt.step)},
                    {"exit_code", json_of(attempt.exit_code)},
                    {"version", attempt.version},
                    {"git", attempt.git}});

  return record_text({{"contract", 1},
                      {"key", point->key},
                      {"ordinal", point->ordinal},
                      {"replica", point->replica},
                      {"state", word_of(point->state)},
                      {"swept", swept},
                      {"analysis", thresholds},
                      {"cells", cells},
                      {"cost", cost_of(attempts)},
                      {"provenance", runs}});
}

void write_result_file(const Store& store, const std::filesystem::path& campaign_directory, std::string_view key) {
  const std::filesystem::path file = point_directory(campaign_directory, std::string(key)) / "result.json";
  const std::string text = result_json(store, key);
  if (read_whole_file(file) != text) write_whole_file(file, text);
}

}  // namespace rouleau::campaign
