// SPDX-License-Identifier: BSD-3-Clause
// Choice of columns, order and window, then one SELECT.
#include "report/phase_table.hpp"

#include "report/analysis.hpp"
#include "report/columns.hpp"
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

std::vector<const Column*> default_columns(const Store& store, const Columns& columns) {
  std::string names = "ordinal";
  for (const std::string& name : columns.swept()) names += "," + name;
  const Database& database = store.database();
  if (database.select_integer("SELECT coalesce(max(cell), 0) FROM result") > 0) names += ",cell";
  names += ",state,class,d_mean_um,d_error_um,d_amplitude_um,d_period_s,asphericity_mean,time_s,attempts,core_h,mlups";
  return columns_named(columns, names);
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

}  // namespace

Table phase_table(Store& reader, const PhaseQuery& query) {
  std::string results = "main.result";
  if (query.analysis) {
    std::vector<ResultRow> rows;
    for (const PointRow& point : reader.points())
      for (ResultRow& row : analyse(point.key, reader.samples(point.key), *query.analysis))
        rows.push_back(std::move(row));
    results = reader.put_temporary_results(rows);
  }
  const Columns columns(reader);
  const std::vector<const Column*> chosen =
      query.columns.empty() ? default_columns(reader, columns) : columns_named(columns, query.columns);

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

}  // namespace rouleau::campaign
