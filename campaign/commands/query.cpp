// SPDX-License-Identifier: BSD-3-Clause
// `rouleau query`: the phase table, or any columns and rows of it.
#include <algorithm>
#include <ostream>

#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "ingest/ingest.hpp"
#include "report/columns.hpp"
#include "report/phase_table.hpp"
#include "study/nearest.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;
using Strings = std::vector<std::string>;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("columns", po::value<std::string>()->value_name("COLUMN,..."),
      "by whole name (fluid.lambda) or last part (lambda)");
  add("where", po::value<std::string>()->value_name("COND"), "condition, such as 'lambda > 4 and class = slipper'");
  add("sort", po::value<std::string>()->value_name("[-]COLUMN,..."), "order; with a minus: descending");
  add("window", po::value<std::string>()->value_name("SECONDS"), "average over another window; nothing is simulated");
  add("analysis", po::value<Strings>()->value_name("NAME=VALUE")->composing(),
      "another threshold: oscillation_window_s, croissant_d_um, slipper_d_um, drift_um");
  add("list-columns", po::bool_switch(), "all columns and their meaning");
}

void set(Analysis& analysis, const std::string& name, const std::string& text) {
  Strings names;
  for (const SettingRow<Analysis>& row : analysis_rows()) {
    names.emplace_back(row.name);
    if (row.name != name) continue;
    const std::optional<double> value = parse_number(text);
    if (!value || *value < row.minimum || *value > row.maximum)
      fail(Exit::usage, "rouleau query: {} = `{}`; a number from {} to {} is needed", name, text, row.minimum,
           row.maximum);
    analysis.*row.member = *value;
    return;
  }
  fail(Exit::usage, "rouleau query: --analysis: there is no `{}`.{}", name, did_you_mean(name, names));
}

std::optional<Analysis> asked_analysis(const CommandLine& line, const Store& store) {
  if (!line.has("window") && !line.has("analysis")) return std::nullopt;
  Analysis analysis = stored_analysis(store);
  if (line.has("window")) set(analysis, "window_s", line.get<std::string>("window"));
  if (line.has("analysis"))
    for (const std::string& word : line.get<Strings>("analysis")) {
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos) fail(Exit::usage, "rouleau query: --analysis `{}` is no NAME=VALUE", word);
      set(analysis, word.substr(0, equals), word.substr(equals + 1));
    }
  if (analysis.slipper_d_um < analysis.croissant_d_um)
    fail(Exit::usage, "rouleau query: slipper_d_um {} is below croissant_d_um {}", analysis.slipper_d_um,
         analysis.croissant_d_um);
  return analysis;
}

int list_columns(const CommandLine& line, const Store& store) {
  const Columns columns(store);
  Table table{"columns", {"name", "type", "meaning"}, {}};
  for (const Column& column : columns.all())
    table.rows.push_back(
        {column.name, std::string(column.type == ColumnType::number ? "number" : "text"), column.description});
  print(line, table);
  return static_cast<int>(Exit::ok);
}

/// Leaves out the last columns of a listing that is wider than the terminal.   returns  their names
std::string fit_into_terminal(const CommandLine& line, Table& table) {
  std::string left_out;
  if (line.format != Format::table || !line.io.out_is_terminal) return left_out;
  while (table.columns.size() > 1 && text_width(table) > static_cast<std::size_t>(line.io.columns)) {
    left_out = table.columns.back() + (left_out.empty() ? "" : ", ") + left_out;
    cut(table, table.columns.size() - 1);
  }
  return left_out;
}

int query(const CommandLine& line) {
  Store store = Store::open_reader(line.directory / "campaign.db");
  if (line.is_set("list-columns")) return list_columns(line, store);
  const auto text = [&](const char* option) { return line.has(option) ? line.get<std::string>(option) : ""; };
  const PhaseQuery query{text("columns"), text("where"), text("sort"), asked_analysis(line, store)};
  Table table = line.format == Format::table ? phase_table_for_eyes(store, query) : phase_table(store, query);
  const std::string left_out = query.columns.empty() ? fit_into_terminal(line, table) : "";
  print(line, table);
  if (!left_out.empty() && !line.quiet)
    line.io.err << fmt::format("{} columns have no room for {}; `--columns` chooses\n", line.io.columns, left_out);
  if (!table.rows.empty()) return static_cast<int>(Exit::ok);
  if (!line.quiet) line.io.err << "no point matches\n";
  return static_cast<int>(Exit::not_found);
}

}  // namespace

const Verb query_verb = {
    "query",
    "the phase table; any columns and rows of it, over any window",
    "[DIR] [--columns COLUMN,...] [--where COND] [--sort COLUMN,...] [--window SECONDS] [--format csv|json]",
    "  rouleau query my-campaign\n"
    "  rouleau query my-campaign --where 'lambda between 4 and 5 and class = slipper'\n"
    "  rouleau query my-campaign --columns lambda,d_mean_um,d_error_um --sort -lambda --format csv\n"
    "  rouleau query my-campaign --window 0.1     averaged over the last 0.1 s instead\n"
    "  rouleau query my-campaign --analysis slipper_d_um=0.4 --analysis croissant_d_um=0.2\n",
    "COND: name = value, !=, <, <=, >, >=, between A and B, in (A, B), is null, is not null; joined by and, or, not,\n"
    "( ). Ends with 3 when nothing matches.\n"
    "\n0.208(40) is 0.208 with a standard error of 0.040; naming the error's column (d_error_um) sets it apart. csv "
    "and\n"
    "json have every digit, and the error always apart.\n",
    Words::campaign,
    true,
    describe,
    query,
};

}  // namespace rouleau::campaign
