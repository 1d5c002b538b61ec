// SPDX-License-Identifier: BSD-3-Clause
// Points, their parameters, their states and the events that say why.
#include "store/store.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

constexpr std::string_view point_columns =
    "SELECT key, ordinal, state, replica, in_study, retries_used, retry_at_unix_s, end_step, end_time_s FROM point ";

State state_in(const Statement& statement, int column) {
  const std::string word = statement.text(column);
  const std::optional<State> state = state_of(word);
  if (!state) fail(Exit::damaged, "campaign.db: `{}` is no state of a point; `rouleau rebuild` makes it anew", word);
  return *state;
}

PointRow point_in(const Statement& statement) {
  PointRow point;
  point.key = statement.text(0);
  point.ordinal = static_cast<int>(statement.integer(1));
  point.state = state_in(statement, 2);
  point.replica = static_cast<int>(statement.integer(3));
  point.in_study = statement.integer(4) != 0;
  point.retries_used = static_cast<int>(statement.integer(5));
  point.retry_at_unix_s = statement.real(6);
  point.end_step = statement.integer(7);
  point.end_time_s = statement.real(8);
  return point;
}

void put_parameters(const Database& database, int ordinal, const std::vector<ParameterRow>& parameters) {
  database.prepare("DELETE FROM parameter WHERE point = ?").bind(ordinal).run();
  Statement insert =
      database.prepare("INSERT INTO parameter (point, name, text, value, swept, position) VALUES (?, ?, ?, ?, ?, ?)");
  int position = 0;
  for (const ParameterRow& row : parameters)
    insert.bind(ordinal, row.name, row.text, row.value, row.swept, ++position).run();
}

void require_changed(const Database& database, std::string_view key) {
  if (database.changes() != 1)
    fail(Exit::not_found, "{}: has no point {}; `rouleau status` lists them", database.file().string(), key);
}

}  // namespace

std::vector<PointRow> Store::points() const {
  Statement statement = database_.prepare(std::string(point_columns) + "ORDER BY ordinal");
  std::vector<PointRow> points;
  while (statement.step()) points.push_back(point_in(statement));
  return points;
}

std::optional<PointRow> Store::point(std::string_view key) const {
  Statement statement = database_.prepare(std::string(point_columns) + "WHERE key = ?");
  statement.bind(key);
  return statement.step() ? std::optional(point_in(statement)) : std::nullopt;
}

std::vector<ParameterRow> Store::parameters(std::string_view key) const {
  Statement statement = database_.prepare(
      "SELECT a.name, a.text, a.value, a.swept FROM parameter a JOIN point p ON p.ordinal = a.point "
      "WHERE p.key = ? ORDER BY a.position");
  statement.bind(key);
  std::vector<ParameterRow> rows;
  while (statement.step())
    rows.push_back({statement.text(0), statement.text(1), statement.optional_real(2), statement.integer(3) != 0});
  return rows;
}

std::map<std::string, std::vector<ParameterRow>> Store::swept_parameters() const {
  Statement statement = database_.prepare(
      "SELECT p.key, a.name, a.text, a.value FROM parameter a JOIN point p ON p.ordinal = a.point WHERE a.swept "
      "ORDER BY p.ordinal, a.position");
  std::map<std::string, std::vector<ParameterRow>> rows;
  while (statement.step())
    rows[statement.text(0)].push_back({statement.text(1), statement.text(2), statement.optional_real(3), true});
  return rows;
}

void Store::add_point(const PointRow& point, const std::vector<ParameterRow>& parameters, std::string_view evidence,
                      std::optional<double> unix_s) {
  Transaction transaction = begin();
  database_
      .prepare(
          "INSERT INTO point (key, ordinal, state, replica, in_study, retries_used, retry_at_unix_s, end_step, "
          "end_time_s) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(point.key, point.ordinal, word_of(point.state), point.replica, point.in_study, point.retries_used,
            point.retry_at_unix_s, point.end_step, point.end_time_s)
      .run();
  put_parameters(database_, point.ordinal, parameters);
  add_event(
      {0, unix_s.value_or(now_unix_s()), point.key, std::nullopt, std::nullopt, point.state, std::string(evidence)});
  transaction.commit();
}

void Store::update_point(const PointRow& point, const std::vector<ParameterRow>& parameters) {
  Transaction transaction = begin();
  database_.prepare("UPDATE point SET in_study = ?, end_step = ?, end_time_s = ? WHERE key = ?")
      .bind(point.in_study, point.end_step, point.end_time_s, point.key)
      .run();
  require_changed(database_, point.key);
  put_parameters(database_, point.ordinal, parameters);
  transaction.commit();
}

void Store::set_retry(std::string_view key, int retries_used, double retry_at_unix_s) {
  database_.prepare("UPDATE point SET retries_used = ?, retry_at_unix_s = ? WHERE key = ?")
      .bind(retries_used, retry_at_unix_s, key)
      .run();
  require_changed(database_, key);
}

bool Store::change_state(std::string_view key, State from, State to, std::string_view evidence,
                         std::optional<int> attempt, std::optional<double> unix_s) {
  Transaction transaction = begin();
  database_.prepare("UPDATE point SET state = ? WHERE key = ? AND state = ?")
      .bind(word_of(to), key, word_of(from))
      .run();
  if (database_.changes() != 1) return false;
  add_event({0, unix_s.value_or(now_unix_s()), std::string(key), attempt, from, to, std::string(evidence)});
  transaction.commit();
  return true;
}

std::vector<EventRow> Store::events(std::string_view key) const {
  Statement statement = database_.prepare(
      "SELECT e.id, e.unix_s, p.key, e.attempt, e.from_state, e.to_state, e.evidence "
      "FROM event e JOIN point p ON p.ordinal = e.point WHERE p.key = ? ORDER BY e.id");
  statement.bind(key);
  std::vector<EventRow> events;
  while (statement.step()) {
    EventRow& event = events.emplace_back();
    event.id = statement.integer(0);
    event.unix_s = statement.real(1);
    event.point = statement.text(2);
    if (!statement.is_null(3)) event.attempt = static_cast<int>(statement.integer(3));
    if (!statement.is_null(4)) event.from = state_in(statement, 4);
    event.to = state_in(statement, 5);
    event.evidence = statement.text(6);
  }
  return events;
}

void Store::add_event(const EventRow& event) {
  const std::optional<std::string> from = event.from ? std::optional(std::string(word_of(*event.from))) : std::nullopt;
  database_
      .prepare(
          "INSERT INTO event (unix_s, point, attempt, from_state, to_state, evidence) "
          "VALUES (?, (SELECT ordinal FROM point WHERE key = ?), ?, ?, ?, ?)")
      .bind(event.unix_s, event.point, event.attempt, from, word_of(event.to), event.evidence)
      .run();
}

}  // namespace rouleau::campaign
