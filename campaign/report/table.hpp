// SPDX-License-Identifier: BSD-3-Clause
// Results as a table for eyes, as CSV or as JSON.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "store/database.hpp"

namespace rouleau::campaign {

/// A listing: every row has as many values as there are columns.
struct Table {
  std::string kind;  ///< names the listing in JSON: "phase", "points" ...
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// The version of every JSON document that `rouleau` prints.
inline constexpr int json_schema_version = 1;

/// Aligned columns; numbers to six significant digits and right-aligned, NULL as `-`.
void write_text(std::ostream& out, const Table& table, bool header);

/// RFC 4180: CRLF line ends, fields quoted where needed, numbers in the shortest form that reads back, NULL empty.
void write_csv(std::ostream& out, const Table& table, bool header);

/// {"schema_version": 1, "kind": "...", "rows": [{column: value}, ...]}, numbers in full precision.
void write_json(std::ostream& out, const Table& table);

/// The same document for rows that come in parts.
class JsonRows {
 public:
  JsonRows(std::ostream& out, std::string kind) : out_(out), kind_(std::move(kind)) {}
  void add(const Table& part);
  void end();  ///< closes the document, which is whole also without any part

 private:
  std::ostream& out_;
  std::string kind_;
  bool begun_ = false;
};

/// A value in the shortest form that reads back; NULL is empty.
std::string exact_text(const Value& value);

/// A value for eyes: six significant digits, NULL is `-`.
std::string short_text(const Value& value);

}  // namespace rouleau::campaign
