// SPDX-License-Identifier: BSD-3-Clause
// Rows and cells.
#include "report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "report/markup.hpp"
#include "report/palette.hpp"
#include "report/parameter_words.hpp"
#include "report/timeline_figure.hpp"

namespace rouleau::campaign {
namespace {

/// A table in a box that scrolls by itself on a narrow screen.
class HtmlTable {
 public:
  HtmlTable(const std::string& name, const std::vector<std::string>& columns) {
    text_ = fmt::format(
        "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><table><caption>{0}</caption>"
        "<thead><tr>",
        escaped(name));
    for (const std::string& column : columns) text_ += fmt::format("<th scope=\"col\">{}</th>", escaped(column));
    text_ += "</tr></thead><tbody>\n";
  }
  void begin_row() { text_ += "<tr>"; }
  void end_row() { text_ += "</tr>\n"; }
  void add(const std::string& text) { add_markup(escaped(text)); }
  void add_markup(const std::string& markup) { text_ += "<td>" + markup + "</td>"; }
  [[nodiscard]] std::string text() const { return text_ + "</tbody></table></div>\n"; }

 private:
  std::string text_;
};

std::string number(const std::optional<double>& value, const char* format = "{:.3g}") {
  return value && std::isfinite(*value) ? fmt::format(fmt::runtime(format), *value) : "–";
}

std::string class_markup(const std::string& phase) {
  for (const ClassLook& look : class_looks)
    if (look.name == phase)
      return fmt::format("<span class=\"sign\" style=\"color:{}\">{}</span> {}", look.colour, look.sign, look.name);
  return escaped(phase);
}

std::string state_text(const ReportPoint& point) {
  const bool shows_progress = point.row.state != State::done && point.fraction() > 0;
  std::string text(word_of(point.row.state));
  if (shows_progress) text += fmt::format(", {:.0f} %", 100 * point.fraction());
  return text + (point.row.in_study ? "" : ", not in the study any more");
}

struct Sums {
  double core_h = 0, wall_s = 0, unrecorded_core_h = 0, updates = 0, computed_s = 0, waited_s = 0;
  std::map<End, int> ends;
  int starts = 0, unrecorded = 0;
};

void add(Sums& sums, const ReportPoint& point, double now) {
  for (const AttemptRow& attempt : point.attempts) {
    const Bar bar = bar_of(point, attempt, now);
    ++sums.starts;
    ++sums.ends[bar.end];
    sums.waited_s += bar.begun - bar.submitted;
    if (attempt.core_s) {
      sums.core_h += *attempt.core_s / 3600;
      sums.wall_s += attempt.wall_s.value_or(0);
      if (attempt.mlups && attempt.wall_s) {
        sums.updates += *attempt.mlups * *attempt.wall_s;
        sums.computed_s += *attempt.wall_s;
      }
    } else {
      ++sums.unrecorded;
      sums.unrecorded_core_h += (bar.ended - bar.begun) * std::max(1, attempt.ranks) / 3600;
    }
  }
}

std::string place_of(const AttemptRow& attempt) {
  std::string place = attempt.host.empty() ? attempt.engine : attempt.host;
  if (!attempt.job_id.empty()) place += ", job " + attempt.job_id;
  return place + (attempt.ranks > 1 ? fmt::format(", {} ranks", attempt.ranks) : "");
}

std::string definition(const std::string& term, const std::string& text) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(term), escaped(text));
}

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + word;
  return text.empty() ? "–" : text;
}

}  // namespace

std::string with_error(const std::optional<double>& value, const std::optional<double>& error) {
  if (!value || !std::isfinite(*value)) return "–";
  if (!error || !(*error > 0) || !std::isfinite(*error)) return fmt::format("{:.3g}", *value);
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(*error))), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}", *value, digits, *error, digits);
}

std::string moment_text(double unix_s) {
  std::string text = iso_utc(unix_s);  // 2026-01-31T12:00:00Z
  text.resize(16);
  text[10] = ' ';
  return text + " UTC";
}

std::string span_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.3g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.1f} min", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} d", seconds / 86400);
}

std::string state_counts(const ReportData& data) {
  std::map<State, int> counts;
  for (const ReportPoint& point : data.points) ++counts[point.row.state];
  std::string text;
  for (const auto& [state, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word_of(state));
  return text;
}

std::string point_table(const ReportData& data) {
  const bool has_cells = std::any_of(data.points.begin(), data.points.end(),
                                     [](const ReportPoint& point) { return point.results.size() > 1; });
  std::vector<std::string> columns = {"point"};
  for (const std::string& axis : data.swept) columns.push_back(axis_title(axis));
  if (has_cells) columns.emplace_back("cell");
  for (const char* column : {"state", "class", "d, µm", "asphericity", "amplitude, µm", "period, s",
                             "tank-treading, 1/s", "t, s", "starts", "core-hours", "run directory"})
    columns.emplace_back(column);
  HtmlTable table("Points", columns);
  static const ResultRow none;
  for (const ReportPoint& point : data.points) {
    double core_h = 0;
    for (const AttemptRow& attempt : point.attempts) core_h += attempt.core_s.value_or(0) / 3600;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, point.results.size()); ++i) {
      const bool has_result = i < point.results.size();
      const ResultRow& cell = has_result ? point.results[i] : none;
      table.begin_row();
      table.add(fmt::format("#{}", point.row.ordinal));
      for (const std::string& axis : data.swept) {
        const auto found =
            std::find_if(point.swept.begin(), point.swept.end(), [&](const ParameterRow& p) { return p.name == axis; });
        table.add(found == point.swept.end() ? "–" : found->text);
      }
      if (has_cells) table.add(has_result ? std::to_string(cell.cell) : "–");
      table.add(state_text(point));
      table.add_markup(
          has_result ? fmt::format("<span title=\"{}\">{}</span>", escaped(cell.phase_reason), class_markup(cell.phase))
                     : "–");
      table.add(with_error(cell.d_mean_um, cell.d_error_um));
      table.add(with_error(cell.asphericity_mean, cell.asphericity_error));
      table.add(number(cell.d_amplitude_um));
      table.add(number(cell.d_period_s));
      table.add(with_error(cell.tank_treading_per_s, cell.tank_treading_error_per_s));
      table.add(has_result ? fmt::format("{:.4g}", cell.time_s) : "–");
      table.add(std::to_string(point.attempts.size()));
      table.add(core_h > 0 ? fmt::format("{:.3g}", core_h) : "–");
      table.add_markup(fmt::format("<a href=\"{}\">{}</a>", link_to(point.link), escaped(point.row.key)));
      table.end_row();
    }
  }
  return table.text();
}

std::string attempt_table(const ReportData& data) {
  HtmlTable table("Starts of the solver",
                  {"point", "start", "begun", "waited", "ran", "where", "steps", "went on from", "end", "reason"});
  for (const ReportPoint& point : data.points) {
    for (const AttemptRow& attempt : point.attempts) {
      const Bar bar = bar_of(point, attempt, data.written_unix_s);
      table.begin_row();
      table.add(fmt::format("#{} {}", point.row.ordinal, point.label()));
      table.add(std::to_string(attempt.number));
      table.add(moment_text(bar.begun));
      table.add(bar.begun > bar.submitted ? span_text(bar.begun - bar.submitted) : "–");
      table.add(span_text(bar.ended - bar.begun));
      table.add(place_of(attempt));
      table.add(fmt::format("{} – {}", attempt.start_step ? std::to_string(*attempt.start_step) : "",
                            attempt.step ? std::to_string(*attempt.step) : ""));
      table.add(attempt.resumed_from.empty() ? "–" : attempt.resumed_from);
      table.add(std::string(word_of(bar.end)) +
                (attempt.exit_code && bar.end != End::running ? fmt::format(" (exit {})", *attempt.exit_code) : ""));
      table.add(attempt.reason.empty() ? "–" : attempt.reason);
      table.end_row();
    }
  }
  return table.text();
}

std::string cost_table(const ReportData& data) {
  Sums all;
  for (const ReportPoint& point : data.points) add(all, point, data.written_unix_s);
  std::string ends;
  for (const auto& [end, count] : all.ends)
    ends += fmt::format("{}{} {}", ends.empty() ? "" : "; ", count, word_of(end));
  std::string text = "<dl>\n";
  text += definition("Core-hours", fmt::format("{:.4g}, as recorded by starts that ended by themselves", all.core_h));
  if (all.unrecorded > 0)
    text += definition(
        "Besides", fmt::format("about {:.4g} core-hours by the clock, of {} starts that run still or left no record",
                               all.unrecorded_core_h, all.unrecorded));
  text += definition("Starts of the solver", all.starts == 0 ? "none yet" : fmt::format("{}: {}", all.starts, ends));
  if (all.waited_s > 0) text += definition("Waiting in a queue", span_text(all.waited_s) + " in all");
  if (all.computed_s > 0)
    text += definition("Rate", fmt::format("{:.3g} million lattice updates a second and start, mean over {}",
                                           all.updates / all.computed_s, span_text(all.computed_s)));
  return text + "</dl>\n";
}

std::string provenance(const ReportData& data) {
  std::set<std::string> solvers, hosts;
  for (const ReportPoint& point : data.points)
    for (const AttemptRow& attempt : point.attempts) {
      if (!attempt.version.empty()) solvers.insert(fmt::format("{} (git {})", attempt.version, attempt.git));
      if (!attempt.host.empty()) hosts.insert(attempt.host);
    }
  const Analysis& a = data.analysis;
  std::string text = "<dl>\n";
  text += definition("Campaign",
                     fmt::format("{}, begun {} by rouleau {} (git {})", data.campaign.name,
                                 moment_text(data.campaign.created_unix_s), data.campaign.version, data.campaign.git));
  text += definition(
      "This page", fmt::format("{}, by rouleau {} (git {})", moment_text(data.written_unix_s), data.version, data.git));
  text += definition("Solver", "rouleau-solver " + joined(solvers));
  text += definition("Hosts", joined(hosts));
  text += definition(
      "Averages",
      fmt::format(
          "over the last {:g} s; oscillation in the last {:g} s; errors are standard errors from block averages",
          a.window_s, a.oscillation_window_s));
  text += definition(
      "Classes",
      fmt::format("croissant: d at most {:g} µm and not leaving the axis; slipper: d at least {:g} µm and not going to "
                  "it; a change of more than {:g} µm from the window before, or anything else, is undecided",
                  a.croissant_d_um, a.slipper_d_um, a.drift_um));
  text += definition("Study file", fmt::format("study.ini, XXH64 {}", data.campaign.study_digest));
  text += "</dl>\n<pre tabindex=\"0\">" + escaped(data.campaign.study_text) + "</pre>\n";
  HtmlTable table("Digests", {"point", "identity", "run.ini, XXH64"});
  for (const ReportPoint& point : data.points) {
    table.begin_row();
    table.add(fmt::format("#{} {}", point.row.ordinal, point.label()));
    table.add(point.identity.empty() ? "–" : point.identity);
    table.add(point.run_file_digest.empty() ? "–" : point.run_file_digest);
    table.end_row();
  }
  return text + "<details><summary>Digests of the points</summary>\n" + table.text() + "</details>\n";
}

}  // namespace rouleau::campaign
