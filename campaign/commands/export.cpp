// SPDX-License-Identifier: BSD-3-Clause
// `rouleau export`: all points with all columns, or all samples, for other programs.
#include <fstream>
#include <ostream>

#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "report/columns.hpp"
#include "report/phase_table.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("samples", po::bool_switch(), "the time series instead of the points");
  add("where", po::value<std::string>()->value_name("COND"), "only these points; as in `rouleau query`");
  add("output,o", po::value<std::string>()->value_name("FILE"), "write a file instead of stdout");
}

std::string all_columns(const Store& store) {
  const Columns columns(store);
  std::string names;
  for (const Column& column : columns.all()) names += (names.empty() ? "" : ",") + column.name;
  return names;
}

void write_points(std::ostream& out, Store& store, const CommandLine& line, Format format, const std::string& where) {
  Table table = phase_table(store, {all_columns(store), where, "ordinal", std::nullopt});
  table.kind = "points";
  if (format == Format::json)
    write_json(out, table);
  else
    write_csv(out, table, line.header);
}

/// One point at a time: a campaign's series need not fit into memory, and no lock is held for long.
void write_samples(std::ostream& out, Store& store, const CommandLine& line, Format format, const std::string& where) {
  const Table points = phase_table(store, {"key", where, "ordinal", std::nullopt});
  JsonRows json(out, "samples");
  bool header = line.header;
  std::string last;
  for (const std::vector<Value>& row : points.rows) {
    const std::string& key = std::get<std::string>(row[0]);
    if (key == last) continue;  // a line a cell
    last = key;
    const std::vector<Value> values = {key};
    Rows rows = store.database().select("SELECT * FROM v_samples WHERE key = ? ORDER BY step, cell", values);
    const Table table{"samples", std::move(rows.columns), std::move(rows.rows)};
    if (format == Format::json)
      json.add(table);
    else
      write_csv(out, table, header);
    header = false;
  }
  if (format == Format::json) json.end();
}

int export_campaign(const CommandLine& line) {
  Store store = Store::open_reader(line.directory / "campaign.db");
  const bool is_default = line.values["format"].defaulted();
  if (line.format == Format::table && !is_default)
    fail(Exit::usage,
         "rouleau export: --format table is not for export; there are csv and json (`rouleau query` prints tables)");
  const Format format = line.format == Format::json ? Format::json : Format::csv;
  const std::string where = line.has("where") ? line.get<std::string>("where") : "";
  const auto write = [&](std::ostream& out) {
    if (line.is_set("samples"))
      write_samples(out, store, line, format, where);
    else
      write_points(out, store, line, format, where);
    out.flush();
  };
  if (!line.has("output")) {
    write(line.io.out);
    return static_cast<int>(Exit::ok);
  }
  const std::filesystem::path file = line.get<std::string>("output");
  const std::filesystem::path aside = file.string() + ".tmp";
  std::ofstream out(aside, std::ios::binary | std::ios::trunc);
  if (out) write(out);
  out.close();
  if (!out) {
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    fail(Exit::failed, "{}: cannot be written; see that its directory exists, is yours and has room", file.string());
  }
  std::filesystem::rename(aside, file);
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb export_verb = {
    "export",
    "points and time series as csv or json",
    "[DIR] [--samples] [--where COND] [--format csv|json] [-o FILE]",
    "  rouleau export my-campaign > points.csv\n"
    "  rouleau export my-campaign --samples --where 'class = slipper' -o slippers.csv\n"
    "  rouleau export my-campaign --format json\n",
    "CSV (RFC 4180) unless --format json; numbers in full precision, no value is an empty field or null.\n",
    Words::campaign,
    true,
    describe,
    export_campaign,
};

}  // namespace rouleau::campaign
