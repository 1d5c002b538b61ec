// SPDX-License-Identifier: BSD-3-Clause
// Rows from one connection to another, a point at a time.
#include "store/copy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rouleau::campaign {
namespace {

/// Copies the rows of a table that belong to one point, column by column of the same name.
class RowCopy {
 public:
  RowCopy(const Database& from, const Database& to, const std::string& table, const std::string& condition)
      : read_(from.prepare(fmt::format("SELECT * FROM {} WHERE {}", table, condition))),
        write_(to.prepare(insertion(table, read_))) {}

  void operator()(const Value& value) {
    read_.bind(value);
    while (read_.step()) {
      row_.clear();
      for (int column = 0; column < read_.columns(); ++column) row_.push_back(read_.value(column));
      write_.bind_values(row_).run();
    }
    read_.reset();
  }

 private:
  static std::string insertion(const std::string& table, const Statement& read) {
    std::vector<std::string> names;
    for (int column = 0; column < read.columns(); ++column) names.push_back(read.column_name(column));
    const std::vector<std::string_view> places(names.size(), "?");
    return fmt::format("INSERT INTO {} ({}) VALUES ({})", table, fmt::join(names, ", "), fmt::join(places, ", "));
  }

  Statement read_, write_;
  std::vector<Value> row_;
};

}  // namespace

Store copy_points(const Store& from, const std::filesystem::path& file, std::span<const std::int64_t> ordinals) {
  Store copy = Store::create(file, from.campaign());
  // Nobody reads the file before it is whole, so nothing need be undone or synced on the way.
  copy.database().execute("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;");
  const auto rows_of = [&](const char* table, const char* condition) {
    return RowCopy(from.database(), copy.database(), table, condition);
  };
  RowCopy settings = rows_of("setting", "name LIKE ?"), points = rows_of("point", "ordinal = ?");
  std::vector<RowCopy> parts;
  for (const char* table : {"parameter", "attempt", "sample", "result", "event"})
    parts.push_back(rows_of(table, "point = ?"));

  Transaction transaction = copy.begin();
  settings("analysis.%");
  for (const std::int64_t ordinal : ordinals) {
    const Snapshot snapshot(from.database());
    points(ordinal);
    for (RowCopy& part : parts) part(ordinal);
  }
  copy.database().execute(
      "UPDATE point SET retry_at_unix_s = 0.0, log_offset = 0, log_tail_hash = '';"
      "UPDATE attempt SET token = '', boot_id = '', pid = 0, start_ticks = 0;");
  transaction.commit();
  return copy;
}

}  // namespace rouleau::campaign
