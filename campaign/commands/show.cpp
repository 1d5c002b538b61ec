// SPDX-License-Identifier: BSD-3-Clause
// `rouleau show POINT`: everything that is known of a point.
#include <ostream>

#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "commands/wish.hpp"
#include "ingest/run_files.hpp"
#include "store/store.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

/// One row of a table as names and values, under a heading that says which one it is.
void add_group(Table& table, const Rows& rows, const std::string& group, const std::string& numbered_by) {
  const auto names_the_point = [&](const std::string& column) {
    return group != "point" && (column == "point" || column == "ordinal" || column == "key");
  };
  for (const std::vector<Value>& row : rows.rows) {
    std::string heading = group;
    for (std::size_t c = 0; c < row.size(); ++c)
      if (rows.columns[c] == numbered_by) heading = fmt::format("{} {}", group, exact_text(row[c]));
    for (std::size_t c = 0; c < row.size(); ++c)
      if (!names_the_point(rows.columns[c]) && rows.columns[c] != numbered_by)
        table.rows.push_back({heading, rows.columns[c], row[c]});
  }
}

void add_progress(Table& table, const std::filesystem::path& run, std::ostream& err) {
  std::vector<std::string> warnings;
  const std::optional<ProgressFile> progress = read_progress_file(run / "progress.json", warnings);
  for (const std::string& warning : warnings) err << "warning: " << warning << '\n';
  if (!progress) return;
  const auto add = [&](const char* name, Value value) { table.rows.push_back({"progress", name, std::move(value)}); };
  const auto number = [](const std::optional<double>& value) { return value ? Value(*value) : Value(); };
  add("step", progress->step);
  add("end_step", progress->end_step);
  add("time_s", progress->time_s);
  add("steps_per_s", number(progress->steps_per_s));
  add("mlups", number(progress->mlups));
  add("eta_s", number(progress->eta_s));
  add("checkpoint_step", progress->checkpoint_step ? Value(*progress->checkpoint_step) : Value());
  add("checkpoint_ms", number(progress->checkpoint_ms));
  add("d_um", number(progress->d_um));
  add("asphericity", number(progress->asphericity));
  add("updated_utc", progress->updated_unix_s ? Value(iso_utc(*progress->updated_unix_s)) : Value());
}

/// group, name, value.
Table everything(const Store& store, const CommandLine& line, const PointRow& point) {
  Table table{"point", {"group", "name", "value"}, {}};
  const std::vector<Value> key = {point.key};
  const Database& database = store.database();
  add_group(table, database.select("SELECT * FROM v_points WHERE key = ?", key), "point", "");
  const std::filesystem::path run = point_directory(line.directory, point.key);
  table.rows.push_back({"point", "directory", run.string()});
  for (const ParameterRow& row : store.parameters(point.key)) table.rows.push_back({"parameter", row.name, row.text});
  add_progress(table, run, line.io.err);
  add_group(table,
            database.select(
                "SELECT r.* FROM result r JOIN point p ON p.ordinal = r.point WHERE p.key = ? ORDER BY cell", key),
            "result of cell", "cell");
  add_group(table, database.select("SELECT * FROM v_attempts WHERE key = ? ORDER BY attempt", key), "attempt",
            "attempt");
  return table;
}

void write_for_eyes(std::ostream& out, const Table& table) {
  std::string heading;
  std::size_t width = 0;
  for (const std::vector<Value>& row : table.rows) width = std::max(width, exact_text(row[1]).size());
  for (const std::vector<Value>& row : table.rows) {
    if (exact_text(row[0]) != heading) {
      out << (heading.empty() ? "" : "\n") << exact_text(row[0]) << '\n';
      heading = exact_text(row[0]);
    }
    const std::string value = short_text(row[2]);
    out << fmt::format("  {:<{}}  {}\n", exact_text(row[1]), width, value.empty() ? "-" : value);
  }
}

int show(const CommandLine& line) {
  const std::vector<PointRow> points = named_points(line, "show");
  const Store store = Store::open_reader(line.directory / "campaign.db");
  Table all{"point", {"point", "group", "name", "value"}, {}};
  for (const PointRow& point : points) {
    const Table table = everything(store, line, point);
    if (line.format == Format::table) {
      if (&point != &points.front()) line.io.out << '\n';
      write_for_eyes(line.io.out, table);
    }
    for (const std::vector<Value>& row : table.rows) all.rows.push_back({point.key, row[0], row[1], row[2]});
  }
  if (line.format != Format::table) print(line, all);
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb show_verb = {
    "show",
    "everything about a point: parameters, progress, results, attempts",
    "POINT... [-C DIR] [--format csv|json]",
    "  rouleau show '#3' -C my-campaign       the third point\n"
    "  rouleau show lambda=5                  all points with this value, of the campaign in this directory\n"
    "  rouleau show 4f1c --format json        a point by the beginning of its key\n",
    "",
    Words::points,
    true,
    nullptr,
    show,
};

}  // namespace rouleau::campaign
