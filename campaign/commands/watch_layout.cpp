// SPDX-License-Identifier: BSD-3-Clause
// Dividing the height between totals, points and changes.
#include "commands/watch_layout.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "commands/duration.hpp"
#include "report/fit_text.hpp"

namespace rouleau::campaign {

namespace {

constexpr int rows_for_some_changes = 14, rows_for_all_changes = 20;
constexpr std::size_t some_changes = 3, all_changes = 5;
constexpr std::size_t least_bar = 8, most_bar = 40;

std::tm local_time(double unix_s) { return fmt::localtime(static_cast<std::time_t>(std::floor(unix_s))); }

std::string core_h_text(double core_h) {
  if (core_h < 10) return fmt::format("{:.2f}", core_h);
  return core_h < 1000 ? fmt::format("{:.1f}", core_h) : fmt::format("{:.0f}", core_h);
}

/// Which points are shown, and what is said of the others.
struct Choice {
  std::vector<const PointStatus*> shown;
  std::string others;
};

Choice choose(const std::vector<PointStatus>& points, std::size_t rows) {
  Choice choice;
  if (points.size() <= rows) {
    for (const PointStatus& s : points) choice.shown.push_back(&s);
    return choice;
  }
  std::array<std::vector<const PointStatus*>, 5> groups;
  for (const PointStatus& s : points) groups.at(static_cast<std::size_t>(standing_of(s))).push_back(&s);
  const auto& running = groups.at(static_cast<std::size_t>(Standing::running));
  auto& trouble = groups.at(static_cast<std::size_t>(Standing::trouble));
  std::size_t room = rows == 0 ? 0 : rows - 1;
  // However many run, a third of the lines is for those in trouble.
  const std::size_t for_trouble = std::min(trouble.size(), std::max(room / 3, room - std::min(room, running.size())));
  std::vector<PointStatus> others;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool is_running = g == static_cast<std::size_t>(Standing::running);
    const std::size_t most = is_running ? room - for_trouble : room;
    for (std::size_t i = 0; i < groups[g].size(); ++i) {
      if (i < most)
        choice.shown.push_back(groups[g][i]);
      else
        others.push_back(*groups[g][i]);
    }
    room -= std::min(most, groups[g].size());
  }
  choice.others = fmt::format("... {} more: {}", others.size(), states_text(others));
  return choice;
}

/// Broken between words into lines of the width.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = std::min(text.size(), begin + width);
    if (end < text.size())
      if (const std::size_t blank = text.rfind(' ', end); blank != std::string::npos && blank > begin) end = blank;
    lines.push_back(text.substr(begin, end - begin));
    begin = std::min(text.find_first_not_of(' ', end), text.size());
  }
  return lines;
}

std::string first_line(const WatchFacts& facts, const Look& look) {
  const std::size_t count = facts.points.size();
  const std::string left =
      fmt::format("{}: {} point{}: {}", facts.name, count, count == 1 ? "" : "s", states_text(facts.points));
  const std::string right = fmt::format("{}  {}", clock_text(facts.now_unix_s), look.hint);
  FittedLine line(look);
  line.add(left);
  if (line.room() >= shown_width(right) + 2) line.add(filled(right, line.room(), true), Tint::faint);
  return line.text();
}

std::string second_line(const WatchFacts& facts, const Look& look) {
  const std::string totals = totals_text(facts);
  FittedLine line(look);
  const std::size_t taken = shown_width(totals) + 2;
  if (line.room() >= taken + least_bar)
    line.add(bar_text(facts.fraction(), std::min(most_bar, line.room() - taken), look.utf8), Tint::running).add("  ");
  return line.add(totals).text();
}

/// What the user should know or do; empty when all goes its way.
std::string advice(const WatchFacts& facts) {
  if (!facts.warning.empty()) return facts.warning;
  if (facts.is_over()) return "All points are through: `rouleau query` shows the results.";
  const bool goes_on = std::any_of(facts.points.begin(), facts.points.end(),
                                   [](const PointStatus& s) { return s.lives || s.point.state == State::running; });
  return goes_on ? "" : "Nothing runs at this moment: `rouleau run` goes on.";
}

}  // namespace

std::string clock_text(double unix_s) { return fmt::format("{:%H:%M:%S}", local_time(unix_s)); }

std::string change_text(const Change& change, double now_unix_s) {
  const std::tm then = local_time(change.unix_s), now = local_time(now_unix_s);
  const bool is_today = then.tm_yday == now.tm_yday && then.tm_year == now.tm_year;
  return fmt::format("{}{} #{} {} -> {}: {}", is_today ? "" : fmt::format("{:%e %b} ", then), clock_text(change.unix_s),
                     change.ordinal, change.from, change.to, change.evidence);
}

std::string totals_text(const WatchFacts& facts) {
  std::string text =
      fmt::format("{:.0f} %, {} core-h", std::floor(100 * facts.fraction()), core_h_text(facts.core_h_used()));
  if (facts.is_over()) return text;
  if (const std::optional<double> left = facts.core_h_left()) text += fmt::format(", ~{} left", core_h_text(*left));
  if (const Outlook outlook = outlook_of(facts.points); outlook.living > 0)
    text += fmt::format(", ends ~{:%e %b %H:%M}, in {}", local_time(facts.now_unix_s + outlook.left_s),
                        duration_text(outlook.left_s));
  return text;
}

std::vector<std::string> watch_lines(const WatchFacts& facts, const Look& look) {
  const auto rows = static_cast<std::size_t>(std::max(1, look.rows));
  std::vector<std::string> lines = {first_line(facts, look), second_line(facts, look)};
  for (const std::string& line : wrapped(advice(facts), static_cast<std::size_t>(look.columns)))
    lines.push_back(FittedLine(look).add(line, facts.warning.empty() ? Tint::none : Tint::trouble).text());
  lines.emplace_back();

  std::size_t changes = 0;
  if (look.rows >= rows_for_some_changes) changes = std::min(some_changes, facts.changes.size());
  if (look.rows >= rows_for_all_changes) changes = std::min(all_changes, facts.changes.size());
  const std::size_t taken = lines.size() + (look.header ? 1 : 0) + (changes > 0 ? changes + 2 : 0);
  const Choice choice = choose(facts.points, rows - std::min(rows, taken));
  const std::vector<std::string> table = table_lines(facts, choice.shown, look);
  lines.insert(lines.end(), table.begin(), table.end());
  if (!choice.others.empty()) lines.push_back(FittedLine(look).add(choice.others, Tint::faint).text());
  if (changes > 0) {
    lines.emplace_back();
    lines.push_back(FittedLine(look).add("Last changes, newest first:", Tint::faint).text());
    for (std::size_t i = 0; i < changes; ++i)
      lines.push_back(FittedLine(look).add(change_text(facts.changes[i], facts.now_unix_s)).text());
  }
  if (lines.size() > rows) lines.resize(rows);
  return lines;
}

}  // namespace rouleau::campaign
