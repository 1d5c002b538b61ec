// SPDX-License-Identifier: BSD-3-Clause
// `rouleau export`: points or samples as text for other programs, or the whole campaign as an SQLite file.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>

#include "commands/output_file.hpp"
#include "commands/verbs.hpp"
#include "commands/version.hpp"
#include "report/columns.hpp"
#include "report/phase_table.hpp"
#include "store/copy.hpp"
#include "study/nearest.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

enum class ExportFormat { csv, json, sqlite };

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("format", po::value<std::string>()->value_name("csv|json|sqlite")->default_value("csv"),
      "text of points or of samples, or all of it as an SQLite file");
  add("samples", po::bool_switch(), "csv, json: the time series instead of the points");
  add("where", po::value<std::string>()->value_name("COND"), "only these points; as in `rouleau query`");
  add("output,o", po::value<std::string>()->value_name("FILE"), "write a file instead of stdout");
  add("overwrite", po::bool_switch(), "replace FILE if it exists");
  add("no-header", po::bool_switch(), "csv: no line of column names");
}

ExportFormat format_of(const std::string& word) {
  if (word == "csv") return ExportFormat::csv;
  if (word == "json") return ExportFormat::json;
  if (word == "sqlite") return ExportFormat::sqlite;
  const std::vector<std::string> formats = {"csv", "json", "sqlite"};
  fail(Exit::usage, "rouleau export: --format {} is not known; there are csv, json and sqlite.{}{}", word,
       did_you_mean(word, formats), word == "table" ? " `rouleau query` prints tables." : "");
}

std::string all_columns(const Store& store) {
  const Columns columns(store);
  std::string names;
  for (const Column& column : columns.all()) names += (names.empty() ? "" : ",") + column.name;
  return names;
}

void write_points(std::ostream& out, Store& store, ExportFormat format, bool header, const std::string& where) {
  Table table = phase_table(store, {all_columns(store), where, "ordinal", std::nullopt});
  table.kind = "points";
  if (format == ExportFormat::json)
    write_json(out, table);
  else
    write_csv(out, table, header);
}

/// One point at a time: a campaign's series need not fit into memory, and no lock is held for long.
void write_samples(std::ostream& out, const Store& store, ExportFormat format, bool header,
                   const std::vector<std::int64_t>& ordinals) {
  JsonRows json(out, "samples");
  for (const std::int64_t ordinal : ordinals) {
    const std::vector<Value> values = {ordinal};
    Rows rows = store.database().select("SELECT * FROM v_samples WHERE ordinal = ? ORDER BY step, cell", values);
    const Table table{"samples", std::move(rows.columns), std::move(rows.rows)};
    if (format == ExportFormat::json)
      json.add(table);
    else
      write_csv(out, table, header);
    header = false;
  }
  if (format == ExportFormat::json) json.end();
}

std::string quoted(const std::string& text, char quote) {
  std::string result(1, quote);
  for (const char c : text) result += c == quote ? std::string(2, c) : std::string(1, c);
  return result + quote;
}

/// The view v_all: a row a point and cell, with the columns of the csv.
std::string view_of_all(const Columns& columns) {
  std::string sql;
  for (const Column& column : columns.all()) {
    sql += sql.empty() ? "CREATE VIEW v_all AS SELECT " : ", ";
    if (column.sql.empty())
      sql += fmt::format("(SELECT {} FROM parameter WHERE point = p.ordinal AND name = {})",
                         column.type == ColumnType::number ? "value" : "text", quoted(column.name, '\''));
    else
      sql += column.sql;
    sql += " AS " + quoted(columns.short_name(column), '"');
  }
  return sql + " FROM v_points p LEFT JOIN result r ON r.point = p.ordinal;";
}

void write_sqlite(const std::filesystem::path& file, const Store& store, const std::vector<std::int64_t>& ordinals,
                  const std::string& where) {
  Store copy = copy_points(store, file, ordinals);
  copy.database().execute(view_of_all(Columns(copy)));
  copy.set_setting("export.made_utc", iso_utc(now_unix_s()));
  copy.set_setting("export.where", where);
  copy.set_setting("export.program", version_text());
}

/// The points that --where names, in the order of their ordinals.
std::vector<std::int64_t> selected_points(Store& store, const std::string& where) {
  std::vector<std::int64_t> ordinals;
  for (const std::vector<Value>& row : phase_table(store, {"ordinal", where, "ordinal", std::nullopt}).rows) {
    const std::int64_t ordinal = std::get<std::int64_t>(row[0]);
    if (ordinals.empty() || ordinals.back() != ordinal) ordinals.push_back(ordinal);  // a row a cell
  }
  if (ordinals.empty() && !where.empty())
    fail(Exit::not_found, "rouleau export: no point matches `{}`; `rouleau query` lists all", where);
  return ordinals;
}

int export_campaign(const CommandLine& line) {
  const ExportFormat format = format_of(line.get<std::string>("format"));
  const bool is_sqlite = format == ExportFormat::sqlite, is_samples = line.is_set("samples");
  if (is_sqlite && !line.has("output"))
    fail(Exit::usage, "rouleau export: --format sqlite needs a file's name, such as `-o campaign.sqlite`");
  if (is_sqlite && is_samples)
    fail(Exit::usage, "rouleau export: an SQLite file holds points and samples; leave --samples out");
  Store store = Store::open_reader(line.directory / "campaign.db");
  const std::string where = line.has("where") ? line.get<std::string>("where") : "";
  const std::vector<std::int64_t> ordinals = selected_points(store, where);

  const auto write = [&](std::ostream& out) {
    const bool header = !line.is_set("no-header");
    if (is_samples)
      write_samples(out, store, format, header, ordinals);
    else
      write_points(out, store, format, header, where);
    out.flush();
  };
  if (!line.has("output")) {
    write(line.io.out);
    return static_cast<int>(Exit::ok);
  }
  const std::filesystem::path file = line.get<std::string>("output");
  write_output_file(file, line.is_set("overwrite"), [&](const std::filesystem::path& aside) {
    if (is_sqlite) return write_sqlite(aside, store, ordinals, where);
    errno = 0;
    std::ofstream out(aside, std::ios::binary);
    if (out) write(out);
    out.close();
    if (!out)
      fail(Exit::failed, "{}: cannot be written: {}. See that its directory is yours and has room.", file.string(),
           std::strerror(errno));
  });
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb export_verb = {
    "export",
    "points and time series as csv, json or an SQLite file",
    "[DIR] [--format csv|json|sqlite] [--samples] [--where COND] [-o FILE] [--overwrite]",
    "  rouleau export my-campaign > points.csv\n"
    "  rouleau export my-campaign --samples --where 'class = slipper' -o slippers.csv\n"
    "  rouleau export my-campaign --format sqlite -o my-campaign.sqlite\n"
    "  sqlite3 my-campaign.sqlite 'SELECT lambda, d_mean_um, d_error_um, class FROM v_phase'\n",
    "csv (RFC 4180) and json have all columns of the points, or with --samples those of the time series; numbers in "
    "full\n"
    "precision, no value is an empty field or null.\n"
    "\nsqlite is one file with all that a phase diagram is made of: points with all parameters (view v_all), results\n"
    "(v_phase), time series (v_samples), attempts and cost (v_attempts), the study file and versions. Named "
    "campaign.db\n"
    "in an empty directory it can be asked by `rouleau query`, over any window. There is no HDF5 form of it.\n"
    "\nWorks while `rouleau run` runs. Ends with 3 when no point matches --where.\n",
    Words::campaign,
    false,
    describe,
    export_campaign,
};

}  // namespace rouleau::campaign
