// SPDX-License-Identifier: BSD-3-Clause
// Choice of columns, order and window, then one SELECT.
#include "report/phase_table.hpp"

#include <algorithm>

#include "report/analysis.hpp"
#include "report/columns.hpp"
#include "report/digits.hpp"
#include "report/filter.hpp"
#include "study/error.hpp"
#include "study/ini.hpp"

namespace rouleau::campaign {
namespace {

std::vector<const Column*> columns_named(const Columns& columns, const std::string& names) {
  std::vector<const Column*> chosen;
  for (const std::string& name : split(names, ',')) {
    if (name.empty()) fail(Exit::usage, "`{}`: a name is missing between the commas", names);
    chosen.push_back(&columns.find(name));
  }
  return chosen;
}

/// What was swept comes first, then `rest`.
std::vector<const Column*> default_columns(const Store& store, const Columns& columns, const std::string& rest) {
  std::string names = "ordinal";
  for (const std::string& name : columns.swept()) names += "," + name;
  const Database& database = store.database();
  if (database.select_integer("SELECT coalesce(max(cell), 0) FROM result") > 0) names += ",cell";
  return columns_named(columns, names + ",state,class," + rest);
}

std::string order_of(const Columns& columns, const std::string& sort, BoundValues& values) {
  std::string order;
  if (sort.empty()) {
    for (const std::string& name : columns.swept()) order += expression_of(columns.find(name), values) + ", ";
  } else {
    for (const std::string& name : split(sort, ',')) {
      const bool descending = name.starts_with('-');
      order += expression_of(columns.find(descending ? name.substr(1) : name), values);
      order += descending ? " DESC, " : ", ";
    }
  }
  return order + "p.ordinal, r.cell";
}

std::vector<const Column*> chosen_columns(const Store& store, const Columns& columns, const PhaseQuery& query,
                                          const std::string& rest) {
  return query.columns.empty() ? default_columns(store, columns, rest) : columns_named(columns, query.columns);
}

Table select(Store& reader, const Columns& columns, const std::vector<const Column*>& chosen, const PhaseQuery& query) {
  std::string results = "main.result";
  if (query.analysis) {
    std::vector<ResultRow> rows;
    for (const PointRow& point : reader.points())
      for (ResultRow& row : analyse(point.key, reader.samples(point.key), *query.analysis))
        rows.push_back(std::move(row));
    results = reader.put_temporary_results(rows);
  }
  Table table{"phase", {}, {}};
  BoundValues values;
  std::string sql;
  for (const Column* column : chosen) {
    table.columns.push_back(columns.short_name(*column));
    sql += (sql.empty() ? "SELECT " : ", ") + expression_of(*column, values);
  }
  sql += " FROM v_points p LEFT JOIN " + results + " r ON r.point = p.ordinal";
  if (!query.where.empty()) sql += " WHERE " + compile_condition(query.where, columns, values);
  sql += " ORDER BY " + order_of(columns, query.sort, values);
  table.rows = reader.database().select(sql, values.values()).rows;
  return table;
}

/// The places of a measure and of its standard error in a row.
struct Measure {
  std::size_t value, error;
};

/// Puts the error into brackets behind the value, or gives both to the same place if the error is shown by itself.
void write_measure(std::vector<Value>& row, const Measure& measure, bool in_brackets_wanted) {
  const auto* value = std::get_if<double>(&row[measure.value]);
  const auto* error = std::get_if<double>(&row[measure.error]);
  if (value == nullptr) return;
  const std::optional<double> known_error = error == nullptr ? std::nullopt : std::optional(*error);
  if (in_brackets_wanted) {
    row[measure.value] = in_brackets(*value, known_error);
  } else if (const std::optional<int> decimals = decimals_of(*value, known_error)) {
    row[measure.value] = to_decimals(*value, *decimals);
    row[measure.error] = to_decimals(*known_error, *decimals);
  }
}

}  // namespace

Table phase_table(Store& reader, const PhaseQuery& query) {
  const Columns columns(reader);
  return select(reader, columns,
                chosen_columns(reader, columns, query,
                               "d_mean_um,d_error_um,d_amplitude_um,d_period_s,asphericity_mean,time_s,attempts,core_h,"
                               "mlups"),
                query);
}

Table phase_table_for_eyes(Store& reader, const PhaseQuery& query) {
  const Columns columns(reader);
  std::vector<const Column*> chosen = chosen_columns(
      reader, columns, query, "d_mean_um,asphericity_mean,d_amplitude_um,d_period_s,time_s,attempts,core_h,mlups");
  const std::size_t shown = chosen.size();
  std::vector<Measure> measures;
  for (std::size_t c = 0; c < shown; ++c) {
    if (chosen[c]->error.empty()) continue;
    const Column* error = &columns.find(chosen[c]->error);
    const auto place = std::find(chosen.begin(), chosen.end(), error);
    measures.push_back({c, static_cast<std::size_t>(place - chosen.begin())});
    if (place == chosen.end()) chosen.push_back(error);
  }
  Table table = select(reader, columns, chosen, query);
  for (const Measure& measure : measures)
    for (std::vector<Value>& row : table.rows) write_measure(row, measure, measure.error >= shown);
  for (std::size_t c = 0; c < shown; ++c)
    if (chosen[c]->type == ColumnType::number) table.right_aligned.insert(c);
  cut(table, shown);
  return table;
}

}  // namespace rouleau::campaign
