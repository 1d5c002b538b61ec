// SPDX-License-Identifier: BSD-3-Clause
// Results: what the analysis made of the samples.
#include "store/store.hpp"

namespace rouleau::campaign {
namespace {

void insert_result(const Database& database, const std::string& table, const ResultRow& r) {
  database
      .prepare("INSERT OR REPLACE INTO " + table +
               " (point, cell, window_s, window_start_s, time_s, samples, step, d_mean_um, d_error_um, d_change_um, "
               "d_amplitude_um, d_period_s, asphericity_mean, asphericity_error, tank_treading_per_s, "
               "tank_treading_error_per_s, tank_treading_reason, class, class_reason, note) "
               "VALUES ((SELECT ordinal FROM main.point WHERE key = ?), "
               "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(r.point, r.cell, r.window_s, r.window_start_s, r.time_s, r.samples, r.step, r.d_mean_um, r.d_error_um,
            r.d_change_um, r.d_amplitude_um, r.d_period_s, r.asphericity_mean, r.asphericity_error,
            r.tank_treading_per_s, r.tank_treading_error_per_s, r.tank_treading_reason, r.phase, r.phase_reason, r.note)
      .run();
}

}  // namespace

std::vector<ResultRow> Store::results(std::string_view point) const {
  Statement statement = database_.prepare(
      "SELECT p.key, r.cell, r.window_s, r.window_start_s, r.time_s, r.samples, r.step, r.d_mean_um, r.d_error_um, "
      "r.d_change_um, r.d_amplitude_um, r.d_period_s, r.asphericity_mean, r.asphericity_error, "
      "r.tank_treading_per_s, r.tank_treading_error_per_s, r.tank_treading_reason, r.class, r.class_reason, "
      "r.note FROM result r JOIN point p ON p.ordinal = r.point WHERE p.key = ? ORDER BY r.cell");
  statement.bind(point);
  std::vector<ResultRow> results;
  while (statement.step()) {
    ResultRow& r = results.emplace_back();
    r.point = statement.text(0);
    r.cell = static_cast<int>(statement.integer(1));
    r.window_s = statement.real(2);
    r.window_start_s = statement.real(3);
    r.time_s = statement.real(4);
    r.samples = statement.integer(5);
    r.step = statement.integer(6);
    r.d_mean_um = statement.optional_real(7);
    r.d_error_um = statement.optional_real(8);
    r.d_change_um = statement.optional_real(9);
    r.d_amplitude_um = statement.optional_real(10);
    r.d_period_s = statement.optional_real(11);
    r.asphericity_mean = statement.optional_real(12);
    r.asphericity_error = statement.optional_real(13);
    r.tank_treading_per_s = statement.optional_real(14);
    r.tank_treading_error_per_s = statement.optional_real(15);
    r.tank_treading_reason = statement.text(16);
    r.phase = statement.text(17);
    r.phase_reason = statement.text(18);
    r.note = statement.text(19);
  }
  return results;
}

void Store::put_result(const ResultRow& result) { insert_result(database_, "main.result", result); }

void Store::delete_results(std::string_view point) {
  database_.prepare("DELETE FROM result WHERE point = (SELECT ordinal FROM point WHERE key = ?)").bind(point).run();
}

std::string Store::put_temporary_results(std::span<const ResultRow> results) {
  const std::string table = "temp.result_of_query";
  // query_only forbids temporary tables too; the file itself stays protected by its own open mode.
  const std::string protection =
      database_.select_integer("PRAGMA query_only") != 0 ? "PRAGMA query_only = ON;" : "PRAGMA query_only = OFF;";
  database_.execute("PRAGMA query_only = OFF;");
  database_.execute("DROP TABLE IF EXISTS " + table + "; CREATE TABLE " + table +
                    " AS SELECT * FROM main.result WHERE 0; CREATE UNIQUE INDEX temp.result_of_query_key "
                    "ON result_of_query (point, cell);");
  for (const ResultRow& result : results) insert_result(database_, table, result);
  database_.execute(protection);
  return table;
}

}  // namespace rouleau::campaign
