// SPDX-License-Identifier: BSD-3-Clause
// One look at the database and the run directories.
#include "commands/watch_facts.hpp"

#include <algorithm>

#include "commands/pause.hpp"
#include "report/columns.hpp"

namespace rouleau::campaign {

namespace {

constexpr double seconds_an_hour = 3600;

std::vector<Change> changes_in(const Database& database, const ChangesWanted& wanted) {
  Statement statement = database.prepare(
      "SELECT id, unix_s, point, from_state, to_state, evidence FROM event "
      "WHERE from_state IS NOT NULL AND id > ? ORDER BY id DESC LIMIT ?");
  statement.bind(wanted.after_id, wanted.most);
  std::vector<Change> changes;
  while (statement.step()) {
    Change& change = changes.emplace_back();
    change.id = statement.integer(0);
    change.unix_s = statement.real(1);
    change.ordinal = static_cast<int>(statement.integer(2));
    change.from = statement.text(3);
    change.to = statement.text(4);
    change.evidence = statement.text(5);
  }
  return changes;
}

/// The class of each point, or the classes of its cells where they differ.
std::map<std::string, std::string> classes_in(const Database& database) {
  Statement statement = database.prepare(
      "SELECT p.key, group_concat(DISTINCT r.class) FROM result r JOIN point p ON p.ordinal = r.point GROUP BY p.key");
  std::map<std::string, std::string> classes;
  while (statement.step()) classes.emplace(statement.text(0), statement.text(1));
  return classes;
}

}  // namespace

bool WatchFacts::is_over() const {
  return std::all_of(points.begin(), points.end(),
                     [](const PointStatus& s) { return (is_final(s.point.state) && !s.lives) || !s.point.in_study; });
}

double WatchFacts::fraction() const {
  double done = 0, all = 0;
  for (const PointStatus& s : points) {
    if (!s.point.in_study || s.point.state == State::cancelled) continue;
    done += static_cast<double>(std::min(s.step, s.point.end_step));
    all += static_cast<double>(s.point.end_step);
  }
  return all > 0 ? done / all : 0;
}

double WatchFacts::core_h_used() const {
  double core_s = ended_core_s;
  for (const PointStatus& s : points)
    if (s.speed() > 0) core_s += s.ranks * static_cast<double>(s.steps_of_life) / s.speed();
  return core_s / seconds_an_hour;
}

std::optional<double> WatchFacts::core_h_left() const {
  auto steps_done = static_cast<double>(ended_steps);
  double steps_left = 0;
  for (const PointStatus& s : points) {
    if (s.speed() > 0) steps_done += static_cast<double>(s.steps_of_life);
    steps_left += static_cast<double>(s.steps_left());
  }
  if (steps_left <= 0) return 0;
  return steps_done > 0 ? std::optional(core_h_used() / steps_done * steps_left) : std::nullopt;
}

WatchFacts WatchReader::read(const ChangesWanted& wanted) {
  const Store store = Store::open_reader(campaign_ / "campaign.db");
  const CampaignRow campaign = store.campaign();
  if (campaign.study_digest != study_digest_) axes_ = Columns(store).swept();
  study_digest_ = campaign.study_digest;

  WatchFacts facts;
  facts.name = campaign.name;
  facts.axes = axes_;
  facts.points = points_.read(store, axes_);
  facts.classes = classes_in(store.database());
  facts.changes = changes_in(store.database(), wanted);
  Statement cost = store.database().prepare(
      "SELECT total(core_s), sum(max(0, step - start_step)) FROM attempt "
      "WHERE core_s IS NOT NULL AND step IS NOT NULL AND start_step IS NOT NULL");
  cost.step();
  facts.ended_core_s = cost.real(0);
  facts.ended_steps = cost.integer(1);
  const Breaker breaker = kept_breaker(store, parse_study(campaign.study_text, campaign_ / "study.ini"));
  if (breaker.has_tripped()) facts.warning = pause_text(breaker);
  facts.now_unix_s = now_unix_s();
  return facts;
}

}  // namespace rouleau::campaign
