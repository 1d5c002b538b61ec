// SPDX-License-Identifier: BSD-3-Clause
// From a word of the command line to points.
#include "report/find_points.hpp"

#include <fmt/format.h>

#include <charconv>

#include "report/columns.hpp"
#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {
namespace {

std::vector<PointRow> by_ordinal(const std::vector<PointRow>& points, std::string_view digits) {
  int ordinal = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), ordinal);
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(Exit::usage, "`#{}` is no number of a point; write #1, #2, ...", digits);
  for (const PointRow& point : points)
    if (point.ordinal == ordinal) return {point};
  return {};
}

std::vector<PointRow> by_key(const std::vector<PointRow>& points, const std::string& word) {
  std::vector<PointRow> found;
  for (const PointRow& point : points)
    if (point.key.starts_with(word)) found.push_back(point);
  if (found.size() > 1)
    fail(Exit::usage, "`{}` is the beginning of {} keys ({}, {}{}); write more of it", word, found.size(), found[0].key,
         found[1].key, found.size() > 2 ? ", ..." : "");
  return found;
}

std::vector<PointRow> by_values(const Store& store, const std::vector<PointRow>& points, const std::string& word) {
  const Columns columns(store);
  BoundValues values;
  std::string condition;
  for (const std::string& part : split(word, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) fail(Exit::usage, "`{}` in `{}` is no name=value", part, word);
    const Column& column = columns.find(trimmed(part.substr(0, equals)));
    const std::string text = trimmed(part.substr(equals + 1));
    if (column.sql.starts_with("r."))
      fail(Exit::usage, "`{}` is a result; points are named by parameters. `rouleau query --where` filters by results",
           column.name);
    const std::optional<double> number = parse_number(text);
    if (column.type == ColumnType::number && !number)
      fail(Exit::usage, "`{}`: {} is a number, `{}` is none", word, column.name, text);
    condition += condition.empty() ? "" : " AND ";
    condition += expression_of(column, values);
    condition += " = " + values.add(column.type == ColumnType::number ? Value(*number) : Value(text));
  }
  const Rows keys = store.database().select("SELECT p.key FROM v_points p WHERE " + condition, values.values());
  std::vector<PointRow> found;
  for (const PointRow& point : points)
    for (const std::vector<Value>& row : keys.rows)
      if (std::get<std::string>(row[0]) == point.key) found.push_back(point);
  return found;
}

}  // namespace

std::vector<PointRow> find_points(const Store& store, const std::string& word) {
  const std::vector<PointRow> points = store.points();
  std::vector<PointRow> found;
  if (word.starts_with('#'))
    found = by_ordinal(points, std::string_view(word).substr(1));
  else if (word.find('=') != std::string::npos)
    found = by_values(store, points, word);
  else if (!word.empty())
    found = by_key(points, word);
  if (found.empty()) fail(Exit::not_found, "no point is called `{}`; `rouleau status` lists the points", word);
  return found;
}

}  // namespace rouleau::campaign
