// SPDX-License-Identifier: BSD-3-Clause
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "machine.hpp"
#include "run/timers.hpp"
#include "size_sweep.hpp"
#include "targets.hpp"

namespace rouleau::speed {

namespace {

/// One line a figure: median, spread, unit. Figures that were not measured are left out.
class FigureLines {
 public:
  explicit FigureLines(const Series& series) : series_(series) {}
  void add(const std::string& name, const std::string& what, const std::string& unit, double factor = 1) {
    if (!series_.has(name)) return;
    const Spread s = spread_of(series_.all().at(name));
    text_ += fmt::format("  {:<52} {:>10.4g} {:<8} +- {:.1f} %\n", what, factor * s.median, unit,
                         s.median == 0 ? 0 : 50 * s.relative());
  }
  [[nodiscard]] std::string under(const std::string& heading) const {
    return text_.empty() ? "" : heading + "\n" + text_ + "\n";
  }

 private:
  const Series& series_;
  std::string text_;
};

std::string fluid_lines(const Series& series) {
  FigureLines lines(series);
  for (const std::string precision : {"single", "double"}) {
    lines.add("attainable_mlups_" + precision, "19 streams scaled in place, " + precision, "MLUPS");
    lines.add("attainable_gb_per_s_" + precision, "  as traffic", "GB/s");
    lines.add("fluid_mlups_" + precision, "fluid, " + precision, "MLUPS");
    lines.add("fluid_ms_" + precision, "  a step", "ms");
    lines.add("fluid_over_attainable_" + precision, "  of the attainable rate", "%", 100);
    lines.add("fluid_bytes_per_node_" + precision, "  memory a node", "bytes");
  }
  return lines.under("fluid alone, one core");
}

std::string coupled_lines(const Series& series) {
  FigureLines lines(series);
  for (const std::string variant : {"2pt_single", "4pt_single", "2pt_double", "4pt_double"}) {
    lines.add("coupled_ms_" + variant, "whole step, " + variant, "ms");
    lines.add("coupled_over_fluid_" + variant, "  over the fluid alone", "");
  }
  lines.add("coupled_mlups_4pt_single", "whole step, 4pt_single", "MLUPS");
  lines.add("tracking_share", "a run, 4pt_single: tracking", "%", 100);
  lines.add("volume_share", "  volume shift", "%", 100);
  lines.add("correction_share", "  correction", "%", 100);
  lines.add("sampling_share", "  samples, progress, health checks", "%", 100);
  lines.add("core_hours_paper_point", "core-hours a point, the paper's time step (5376)", "h");
  lines.add("core_hours_large_step", "core-hours a point, the large time step", "h");
  return lines.under("the paper's point, one core");
}

std::string parallel_lines(const Series& series) {
  FigureLines lines(series);
  for (const std::string kernel : {"2pt", "4pt"})
    lines.add("two_rank_ms_" + kernel + "_single", "two ranks, whole step, " + kernel + "_single", "ms");
  lines.add("two_rank_speedup_2pt", "  speedup, 2pt_single", "");
  lines.add("two_rank_speedup", "  speedup, 4pt_single", "");
  lines.add("two_jobs_throughput", "two one-rank jobs side by side, over one", "");
  return lines.under("two cores");
}

std::string checkpoint_lines(const Series& series) {
  FigureLines lines(series);
  lines.add("checkpoint_mb", "size", "MB");
  for (const std::string verb : {"write", "verify", "read"}) {
    lines.add("checkpoint_" + verb + "_ms", verb, "ms");
    lines.add("checkpoint_" + verb + "_mb_per_s", "", "MB/s");
  }
  lines.add("checkpoint_share", "share of a run at the study's interval", "%", 100);
  return lines.under("checkpoint");
}

bool is_of_membrane(Part part) {
  return part != Part::collide && part != Part::halos && part != Part::correction && part != Part::control;
}

std::string part_lines(const Series& series, const PointFacts& point, const std::string& group, int ranks) {
  const auto has = [&](const std::string& v) { return series.has(group + "." + v + "." + part_names[0]); };
  std::string text;
  for (const std::string variant : {"2pt_single", "4pt_single", "2pt_double", "4pt_double"}) {
    if (!has(variant)) continue;
    text += fmt::format("parts of the step, {}, {}\n  {:<16} {:>9} {:>8} {:>14} {:>14}\n", variant,
                        ranks == 1 ? "one rank" : "rank 0 of two", "part", "us", "%", "ns a triangle", "ns a vertex");
    const double step = series.median((ranks == 1 ? "coupled_ms_" : "two_rank_ms_") + variant);
    for (std::size_t p = 0; p < part_names.size(); ++p) {
      const double ms = series.median(group + "." + variant + "." + part_names[p]);
      text += fmt::format("  {:<16} {:>9.1f} {:>8.2f}", part_names[p], 1e3 * ms, 100 * ms / step);
      if (is_of_membrane(static_cast<Part>(p)))
        text += fmt::format(" {:>14.2f} {:>14.2f}", 1e6 * ms / static_cast<double>(point.triangles),
                            1e6 * ms / static_cast<double>(point.vertices));
      text += "\n";
    }
    text += "\n";
  }
  return text;
}

std::set<int> edges_of(const Series& series) {
  const std::string prefix = "sweep.fluid_ms.";
  std::set<int> edges;
  for (const auto& [name, values] : series.all())
    if (name.starts_with(prefix)) edges.insert(std::stoi(name.substr(prefix.size())));
  return edges;
}

std::string sweep_lines(const Series& series) {
  const std::set<int> edges = edges_of(series);
  if (edges.empty()) return "";
  const std::vector<std::string> names{"fluid", "tracking", "shell_raycast", "full_raycast", "column_raycast"};
  std::string text = fmt::format("growth with the lattice N^3, 20 (N/3)^2 triangles; ms\n  {:<10}", "N");
  for (const std::string& name : names) text += fmt::format(" {:>15}", name);
  for (const int edge : edges) {
    text += fmt::format("\n  {:<10}", edge);
    for (const std::string& name : names)
      text += fmt::format(" {:>15.4g}", series.median(fmt::format("sweep.{}_ms.{}", name, edge)));
  }
  text += fmt::format("\n  {:<10}", "exponent");
  for (const std::string& name : names) text += fmt::format(" {:>15.2f}", series.median(name + "_exponent"));
  text += fmt::format("\n  {:<10} {:>15} {:>15} {:>15} {:>15}\n", "expected", 3, 2, 4, 5);
  text += fmt::format(
      "  full_raycast: measured on {} planes of nodes and scaled to all. column_raycast: all nodes, only "
      "the triangles in\n  a node's column; the paper has no such thing.\n\n",
      SizeSweep::measured_planes);
  if (series.has("run_ratio_full_raycast"))
    text += fmt::format(
        "a run at the paper's point with tracking : shell ray cast : full ray cast\n"
        "  here       1 : {:.3g} : {:.3g}       (full cast by columns: {:.3g})\n"
        "  the paper  1 : 8.7 : 78           (2 weeks, 4 months, 3 years)\n\n",
        series.median("run_ratio_shell_raycast"), series.median("run_ratio_full_raycast"),
        series.median("run_ratio_column_raycast"));
  return text;
}

std::string target_lines(const Series& series) {
  std::string text = "targets\n";
  for (const Target& t : targets(series))
    text += fmt::format("  {:<34} {:>10.4g}  {:<12} {}\n", t.figure, t.value, t.text,
                        t.is_reached() ? "reached" : "NOT REACHED");
  return text;
}

std::string machine_lines(const nlohmann::ordered_json& json) {
  const auto& machine = json.at("machine");
  const auto& load = json.at("load");
  const double foreign = load.at("cores_busy_with_others").get<double>() + load.at("cores_stolen").get<double>();
  std::string text =
      fmt::format("{}, {} cores, {}; {}\n{}", machine.at("cpu").get<std::string>(), machine.at("cores").get<int>(),
                  machine.at("caches").get<std::string>(), machine.at("memory").get<std::string>(),
                  json.at("versions").at("all").get<std::string>());
  text += fmt::format("{:.0f} s, others kept {:.2f} cores busy\n", load.at("wall_s").get<double>(), foreign);
  if (foreign > tolerable_foreign_cores)
    text += "WARNING: the machine was not quiet; these figures are no measure of the code\n";
  return text + "\n";
}

}  // namespace

std::string result_table(const Series& series, const PointFacts& point, const nlohmann::ordered_json& json) {
  return machine_lines(json) + fluid_lines(series) + coupled_lines(series) + parallel_lines(series) +
         part_lines(series, point, "parts", 1) + part_lines(series, point, "parts_two_ranks", 2) +
         checkpoint_lines(series) + sweep_lines(series) + target_lines(series);
}

}  // namespace rouleau::speed
