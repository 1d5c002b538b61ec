// SPDX-License-Identifier: BSD-3-Clause
// Reading, and choosing what fits.
#include "commands/report_contents.hpp"

#include <algorithm>
#include <chrono>

#include "commands/version.hpp"
#include "executor/attempt.hpp"
#include "ingest/ingest.hpp"
#include "ingest/run_files.hpp"
#include "report/phase_figure.hpp"
#include "report/series_figure.hpp"
#include "report/thin.hpp"
#include "report/timeline_figure.hpp"
#include "study/error.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

constexpr std::size_t most_a_curve = 2000, least_a_curve = 200, most_of_all_curves = 120000, most_of_overlay = 24000;
constexpr std::size_t most_tiles = 120, most_times = 6, most_points_with_shapes = 60, most_slices = 12;

double unix_s(std::filesystem::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration<double>(system.time_since_epoch()).count();
}

/// When an attempt that was handed to a scheduler began to compute, if it has.
std::optional<double> begun(const AttemptRow& attempt, const std::filesystem::path& run) {
  if (attempt.ended_unix_s && attempt.wall_s) return *attempt.ended_unix_s - *attempt.wall_s;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(attempt_directory(run, attempt.number) / "started.json", error);
  if (error) return std::nullopt;
  return unix_s(time);
}

void look_at(ReportPoint& point, const std::filesystem::path& run) {
  std::vector<std::string> warnings;  // `status` and `verify` tell of damaged files; here they are only left out
  if (const auto progress = read_progress_file(run / "progress.json", warnings)) point.step = progress->step;
  for (const AttemptRow& attempt : point.attempts) {
    if (attempt.engine == local_engine) continue;
    if (const auto time = begun(attempt, run)) point.began_unix_s[attempt.number] = *time;
  }
  try {
    const Point known = read_point(run / "point.json");
    point.identity = known.identity;
    point.run_file_digest = known.run_file_digest;
  } catch (const Error&) {
    point.identity = "point.json cannot be read; `rouleau verify` says why";
  }
}

/// Points that are shown with pictures: all, or as many as allowed, spread evenly over the list.
std::vector<const ReportPoint*> spread_points(const ReportData& data, std::size_t most,
                                              const std::map<int, std::vector<ShapeFile>>& files) {
  std::vector<const ReportPoint*> with_files, chosen;
  for (const ReportPoint& point : data.points)
    if (!files.at(point.row.ordinal).empty()) with_files.push_back(&point);
  std::vector<double> positions(with_files.size());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<double>(i);
  for (const std::size_t i : spread_evenly(positions, most)) chosen.push_back(with_files[i]);
  return chosen;
}

}  // namespace

ReportData report_data(const std::filesystem::path& campaign, const std::filesystem::path& report) {
  const Store store = Store::open_reader(campaign / "campaign.db");
  const auto points = static_cast<std::size_t>(store.database().select_integer("SELECT count(*) FROM point"));
  ReportData data = read_report(
      store, std::clamp(most_of_all_curves / std::max<std::size_t>(1, points), least_a_curve, most_a_curve));
  data.analysis = stored_analysis(store);
  data.version = version();
  data.git = git_hash();
  const std::filesystem::path from = std::filesystem::weakly_canonical(report).parent_path();
  for (ReportPoint& point : data.points) {
    const std::filesystem::path run = point_directory(campaign, point.row.key);
    point.link = std::filesystem::weakly_canonical(run).lexically_relative(from).string() + "/";
    look_at(point, run);
  }
  return data;
}

std::vector<Figure> report_figures(const ReportData& data) {
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  add(phase_figure(data));
  add(map_figure(data));
  add(overlay_figure(data, most_of_overlay));
  add(timeline_figure(data));
  for (const ReportPoint& point : data.points) add(series_figure(data, point));
  return figures;
}

void add_shapes(PageParts& parts, const ReportData& data, const std::filesystem::path& campaign, ShapeReader& reader) {
  std::map<int, std::vector<ShapeFile>> files;
  for (const ReportPoint& point : data.points)
    files[point.row.ordinal] = shape_files(point_directory(campaign, point.row.key));
  const std::vector<const ReportPoint*> shown = spread_points(data, most_points_with_shapes, files);
  const std::size_t times = std::clamp<std::size_t>(most_tiles / std::max<std::size_t>(1, shown.size()), 1, most_times);
  for (const ReportPoint* point : shown) {
    const std::vector<ShapeFile>& of_point = files[point->row.ordinal];
    std::vector<double> steps;
    for (const ShapeFile& file : of_point) steps.push_back(static_cast<double>(file.step));
    for (const std::size_t i : spread_evenly(steps, times))
      if (auto shape = reader.read(of_point[i], false)) parts.shapes[point->row.ordinal].push_back(std::move(*shape));
  }
  for (const ReportPoint* point : spread_points(data, most_slices, files)) {
    const std::vector<ShapeFile>& of_point = files[point->row.ordinal];
    const auto newest =
        std::find_if(of_point.rbegin(), of_point.rend(), [](const ShapeFile& file) { return file.has_flags; });
    if (newest == of_point.rend()) continue;
    if (auto shape = reader.read(*newest, true); shape && shape->slice)
      parts.slices[point->row.ordinal] = std::move(*shape);
  }
  reader.forget_unread();
  const auto with_files = static_cast<std::size_t>(
      std::count_if(files.begin(), files.end(), [](const auto& entry) { return !entry.second.empty(); }));
  if (with_files > most_slices)
    parts.notes.push_back(
        fmt::format("Cells are drawn of {} points and flags of {}, spread evenly over the {} that have "
                    "any; `rouleau render` draws each.",
                    shown.size(), most_slices, with_files));
  if (std::string problem = reader.take_problem(); !problem.empty()) parts.notes.push_back(std::move(problem));
}

}  // namespace rouleau::campaign
