// SPDX-License-Identifier: BSD-3-Clause
// Boxes over hours, a row a point.
#include "report/timeline_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/gnuplot_text.hpp"
#include "report/palette.hpp"

namespace rouleau::campaign {
namespace {

struct EndLook {
  End end;
  std::string_view word, colour;
  int sign;  ///< point type at the end of the bar; 0 = none
};

constexpr std::array<EndLook, 6> looks = {{{End::finished, "finished", green, 7},
                                           {End::stopped, "stopped", sky, 11},
                                           {End::crashed, "crashed", vermillion, 2},
                                           {End::failed, "failed or refused", black, 5},
                                           {End::running, "running", blue, 0},
                                           {End::superseded, "superseded", grey, 1}}};

}  // namespace

End end_of(const AttemptRow& attempt) {
  if (attempt.state != AttemptState::ended) return End::running;
  switch (attempt.exit_code.value_or(-1)) {
    case 0:
      return End::finished;
    case 75:
      return End::stopped;
    case 76:
      return End::superseded;
    case 64:
    case 65:
    case 70:
      return End::failed;
    default:
      return End::crashed;
  }
}

std::string_view word_of(End end) { return looks[static_cast<std::size_t>(end)].word; }

Bar bar_of(const ReportPoint& point, const AttemptRow& attempt, double now) {
  Bar bar{attempt.started_unix_s, attempt.started_unix_s, now, end_of(attempt)};
  if (const auto begun = point.began_unix_s.find(attempt.number); begun != point.began_unix_s.end())
    bar.begun = std::max(bar.submitted, begun->second);
  else if (attempt.engine != local_engine && bar.end == End::running)
    bar.begun = now;  // it waits still
  if (bar.end != End::running) bar.ended = attempt.ended_unix_s.value_or(bar.begun + attempt.wall_s.value_or(0));
  bar.ended = std::max(bar.ended, bar.begun);
  return bar;
}

std::optional<Figure> timeline_figure(const ReportData& data) {
  double first = data.written_unix_s, last = 0;
  std::size_t attempts = 0, crashes = 0, waits = 0, rows = 0;
  for (const ReportPoint& point : data.points) {
    rows += point.attempts.empty() ? 0 : 1;
    for (const AttemptRow& attempt : point.attempts) {
      const Bar bar = bar_of(point, attempt, data.written_unix_s);
      first = std::min(first, bar.submitted);
      last = std::max(last, bar.ended);
      ++attempts;
      crashes += bar.end == End::crashed ? 1 : 0;
      waits += bar.begun > bar.submitted ? 1 : 0;
    }
  }
  if (attempts == 0) return std::nullopt;
  const double span_h = std::max(last - first, 1.0) / 3600;
  const char* unit = span_h > 96 ? "days" : span_h > 0.3 ? "hours" : "minutes";
  const double unit_s = span_h > 96 ? 86400 : span_h > 0.3 ? 3600 : 60;

  Figure figure;
  figure.name = "timeline";
  figure.title = "Starts of the solver";
  figure.description = fmt::format(
      "A row a point, a bar a start of the solver, from the first start on: {} starts of {} "
      "points, {} of them crashed, {} waited in a queue first.",
      attempts, rows, crashes, waits);
  figure.data =
      gnuplot_comment(fmt::format("begin and end of a bar in {} since {}, row, kind (0 finished, 1 stopped, 2 "
                                  "crashed, 3 failed, 4 running, 5 superseded, 6 waiting), attempt",
                                  unit, iso_utc(first)));
  const bool is_short = std::all_of(data.points.begin(), data.points.end(),
                                    [](const ReportPoint& point) { return point.label().size() <= 14; });
  std::string tics;
  std::array<bool, 7> occurs{};
  std::size_t row = 0;
  const std::size_t every = rows > 60 ? 1 + rows / 40 : 1;
  for (const ReportPoint& point : data.points) {
    if (point.attempts.empty()) continue;
    if (row++ % every == 0)
      tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ",
                          gnuplot_quoted(fmt::format("#{}{}", point.row.ordinal, is_short ? " " + point.label() : "")),
                          row);
    for (const AttemptRow& attempt : point.attempts) {
      const Bar bar = bar_of(point, attempt, data.written_unix_s);
      const auto line = [&](double begin, double end, std::size_t kind) {
        figure.data += fmt::format("{:.7g} {:.7g} {} {} {}\n", (begin - first) / unit_s, (end - first) / unit_s, row,
                                   kind, attempt.number);
        occurs[kind] = true;
      };
      if (bar.begun > bar.submitted) line(bar.submitted, bar.begun, 6);
      line(bar.begun, bar.ended, static_cast<std::size_t>(bar.end));
    }
  }
  std::string plots;
  const auto add = [&](std::size_t kind, std::string_view look, std::string_view title) {
    plots += fmt::format(
        "{}'timeline.dat' using (($1+$2)/2):($4 == {} ? $3 : NaN):1:2:($3-0.34):($3+0.34) with "
        "boxxyerror {} title '{}'",
        plots.empty() ? "" : ", \\\n  ", kind, look, title);
  };
  if (occurs[6]) add(6, "lc rgb '#767676' fs pattern 4 border", "waiting in a queue");
  for (const EndLook& look : looks) {
    if (!occurs[static_cast<std::size_t>(look.end)]) continue;
    add(static_cast<std::size_t>(look.end), fmt::format("lc rgb '{}' fs solid 0.45 border", look.colour),
        look.sign == 0 ? look.word : "");
    if (look.sign != 0)
      plots += fmt::format(
          ", \\\n  'timeline.dat' using 2:($4 == {} ? $3 : NaN) with points pt {} ps {} lw 1.5 lc rgb "
          "'{}' title '{}'",
          static_cast<int>(look.end), look.sign, rows > 60 ? 0.5 : 0.8, look.colour, look.word);
  }
  figure.height_px = 135 + static_cast<double>(rows) * (rows > 60 ? 6 : 20);
  figure.height_cm = std::min(23.0, 2.5 + static_cast<double>(rows) * (rows > 60 ? 0.2 : 0.4));
  figure.script = fmt::format(
      "set xlabel {}\nset xrange [0:*]\nset offsets graph 0, graph 0.02, 0, 0\nset yrange [{}.5:0.5]\nset ytics ({})\n"
      "set grid noytics\nset key outside top center horizontal maxrows 3 samplen 1.5\nplot {}\n",
      gnuplot_quoted(fmt::format("{} since {}", unit, iso_utc(first))), rows, tics, plots);
  return figure;
}

}  // namespace rouleau::campaign
