// SPDX-License-Identifier: BSD-3-Clause
// Attempts: one row a start of the solver.
#include <array>

#include "store/store.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

constexpr std::array<std::string_view, 3> attempt_words = {"planned", "launched", "ended"};

constexpr std::string_view attempt_columns =
    "SELECT p.key, a.number, a.token, a.state, a.host, a.boot_id, a.pid, a.start_ticks, a.ranks, a.cores, "
    "a.started_unix_s, a.ended_unix_s, a.exit_code, a.reason, a.resumed_from, a.start_step, a.step, a.wall_s, "
    "a.core_s, "
    "a.mlups, a.version, a.git, a.checkpoint_at_start, a.engine, a.job_id, a.job_state FROM attempt a JOIN point p ON "
    "p.ordinal = a.point ";

AttemptState attempt_state_in(const Statement& statement, int column) {
  const std::string word = statement.text(column);
  for (std::size_t i = 0; i < attempt_words.size(); ++i)
    if (attempt_words[i] == word) return static_cast<AttemptState>(i);
  fail(Exit::damaged, "campaign.db: `{}` is no state of an attempt; `rouleau rebuild` makes it anew", word);
}

AttemptRow attempt_in(const Statement& statement) {
  AttemptRow attempt;
  attempt.point = statement.text(0);
  attempt.number = static_cast<int>(statement.integer(1));
  attempt.token = statement.text(2);
  attempt.state = attempt_state_in(statement, 3);
  attempt.host = statement.text(4);
  attempt.boot_id = statement.text(5);
  attempt.pid = statement.integer(6);
  attempt.start_ticks = statement.integer(7);
  attempt.ranks = static_cast<int>(statement.integer(8));
  attempt.cores = statement.text(9);
  attempt.started_unix_s = statement.real(10);
  attempt.ended_unix_s = statement.optional_real(11);
  if (!statement.is_null(12)) attempt.exit_code = static_cast<int>(statement.integer(12));
  attempt.reason = statement.text(13);
  attempt.resumed_from = statement.text(14);
  attempt.start_step = statement.optional_integer(15);
  attempt.step = statement.optional_integer(16);
  attempt.wall_s = statement.optional_real(17);
  attempt.core_s = statement.optional_real(18);
  attempt.mlups = statement.optional_real(19);
  attempt.version = statement.text(20);
  attempt.git = statement.text(21);
  attempt.checkpoint_at_start = statement.integer(22);
  attempt.engine = statement.text(23);
  attempt.job_id = statement.text(24);
  attempt.job_state = statement.text(25);
  return attempt;
}

std::vector<AttemptRow> attempts_in(Statement& statement) {
  std::vector<AttemptRow> attempts;
  while (statement.step()) attempts.push_back(attempt_in(statement));
  return attempts;
}

}  // namespace

std::vector<AttemptRow> Store::attempts(std::string_view point) const {
  Statement statement = database_.prepare(std::string(attempt_columns) + "WHERE p.key = ? ORDER BY a.number");
  statement.bind(point);
  return attempts_in(statement);
}

std::optional<AttemptRow> Store::newest_attempt(std::string_view point) const {
  Statement statement =
      database_.prepare(std::string(attempt_columns) + "WHERE p.key = ? ORDER BY a.number DESC LIMIT 1");
  statement.bind(point);
  return statement.step() ? std::optional(attempt_in(statement)) : std::nullopt;
}

std::map<std::string, AttemptRow> Store::newest_attempts() const {
  Statement statement = database_.prepare(std::string(attempt_columns) +
                                          "WHERE a.number = (SELECT max(number) FROM attempt WHERE point = a.point)");
  std::map<std::string, AttemptRow> newest;
  for (AttemptRow& attempt : attempts_in(statement)) newest.emplace(attempt.point, std::move(attempt));
  return newest;
}

std::optional<AttemptRow> Store::attempt_with_token(std::string_view token) const {
  Statement statement = database_.prepare(std::string(attempt_columns) + "WHERE a.token = ?");
  statement.bind(token);
  return statement.step() ? std::optional(attempt_in(statement)) : std::nullopt;
}

std::vector<AttemptRow> Store::open_attempts() const {
  Statement statement =
      database_.prepare(std::string(attempt_columns) + "WHERE a.state <> 'ended' ORDER BY a.point, a.number");
  return attempts_in(statement);
}

void Store::put_attempt(const AttemptRow& attempt) {
  database_
      .prepare(
          "INSERT OR REPLACE INTO attempt (point, number, token, state, host, boot_id, pid, start_ticks, ranks, cores, "
          "started_unix_s, ended_unix_s, exit_code, reason, resumed_from, start_step, step, wall_s, core_s, mlups, "
          "version, git, checkpoint_at_start, engine, job_id, job_state) VALUES ((SELECT ordinal FROM point WHERE "
          "key = ?), ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(attempt.point, attempt.number, attempt.token, attempt_words[static_cast<std::size_t>(attempt.state)],
            attempt.host, attempt.boot_id, attempt.pid, attempt.start_ticks, attempt.ranks, attempt.cores,
            attempt.started_unix_s, attempt.ended_unix_s, attempt.exit_code, attempt.reason, attempt.resumed_from,
            attempt.start_step, attempt.step, attempt.wall_s, attempt.core_s, attempt.mlups, attempt.version,
            attempt.git, attempt.checkpoint_at_start, attempt.engine, attempt.job_id, attempt.job_state)
      .run();
}

}  // namespace rouleau::campaign
