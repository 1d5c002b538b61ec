// SPDX-License-Identifier: BSD-3-Clause
#include "result.hpp"

#include <algorithm>

#include "targets.hpp"

namespace rouleau::speed {

using nlohmann::ordered_json;

namespace {

double core_hours(double ms_per_step, std::int64_t steps) { return ms_per_step * static_cast<double>(steps) / 3.6e6; }

/// The paper's table 1 : 8.7 : 78, here: a run that casts rays in each step instead of tracking.
void derive_run_ratio(Series& series, const std::string& method) {
  series.derive("run_ratio_" + method,
                {"coupled_ms_4pt_single", "parts.4pt_single.tracking", method + "_ms_paper_point"},
                [](const std::vector<double>& v) { return (v[0] - v[1] + v[2]) / v[0]; });
}

}  // namespace

void derive_figures(Series& series, const PointFacts& point) {
  for (const std::string precision : {"single", "double"}) {
    series.derive_ratio("fluid_over_attainable_" + precision, "fluid_mlups_" + precision,
                        "attainable_mlups_" + precision);
    for (const std::string kernel : {"2pt", "4pt"})
      series.derive_ratio("coupled_over_fluid_" + kernel + "_" + precision, "coupled_ms_" + kernel + "_" + precision,
                          "fluid_ms_" + precision);
  }
  series.derive_ratio("two_rank_speedup", "coupled_ms_4pt_single", "two_rank_ms_4pt_single");
  series.derive_ratio("two_rank_speedup_2pt", "coupled_ms_2pt_single", "two_rank_ms_2pt_single");
  series.derive("two_jobs_throughput", {"two_jobs_steps_per_s", "coupled_ms_4pt_single"},
                [](const std::vector<double>& v) { return v[0] * v[1] * 1e-3; });
  for (const std::string kernel : {"2pt", "4pt"})
    for (const auto& [name, steps] : {std::pair<std::string, std::int64_t>{"core_hours_paper_point", point.steps},
                                      {"core_hours_large_step", point.steps_large}})
      series.derive(name + (kernel == "4pt" ? "" : "_2pt"), {"coupled_ms_" + kernel + "_single"},
                    [n = steps](const std::vector<double>& v) { return core_hours(v[0], n); });
  series.derive("coupled_mlups_4pt_single", {"coupled_ms_4pt_single"},
                [&](const std::vector<double>& v) { return 1e-3 * static_cast<double>(point.nodes) / v[0]; });
  for (const std::string verb : {"write", "verify", "read"})
    series.derive("checkpoint_" + verb + "_mb_per_s", {"checkpoint_mb", "checkpoint_" + verb + "_ms"},
                  [](const std::vector<double>& v) { return 1e3 * v[0] / v[1]; });
  derive_run_ratio(series, "shell_raycast");
  derive_run_ratio(series, "full_raycast");
  derive_run_ratio(series, "column_raycast");
}

ordered_json result_json(const Series& series, const PointFacts& point) {
  ordered_json json = ordered_json::object(), spreads = ordered_json::object();
  for (const auto& [name, values] : series.all()) {
    const Spread s = spread_of(values);
    std::string pointer = "/" + name;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    json[ordered_json::json_pointer(pointer)] = s.median;
    spreads[name] = {{"relative", s.relative()},
                     {"lower_quartile", s.lower_quartile},
                     {"upper_quartile", s.upper_quartile},
                     {"min", s.min},
                     {"max", s.max},
                     {"rounds", s.count}};
  }
  json["spread"] = spreads;
  json["targets"] = ordered_json::array();
  for (const Target& t : targets(series))
    json["targets"].push_back(
        {{"figure", t.figure}, {"value", t.value}, {"target", t.text}, {"reached", t.is_reached()}});
  json["point"] = {{"nodes", point.nodes},
                   {"vertices", point.vertices},
                   {"triangles", point.triangles},
                   {"steps", point.steps},
                   {"steps_large", point.steps_large}};
  return json;
}

}  // namespace rouleau::speed
