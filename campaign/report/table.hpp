// SPDX-License-Identifier: BSD-3-Clause
// Results as a table for eyes, as CSV or as JSON.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "store/database.hpp"

namespace rouleau::campaign {

/// A listing: every row has as many values as there are columns.
struct Table {
  std::string kind;  ///< names the listing in JSON: "phase", "points" ...
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
  std::set<std::size_t> right_aligned = {};  ///< columns of numbers that are texts, 0.208(40), or may be missing
};

/// Leaves the first `columns` columns.
void cut(Table& table, std::size_t columns);

/// The version of every JSON document that `rouleau` prints.
inline constexpr int json_schema_version = 1;

/// Aligned columns, numbers to the right, words to the left; values as short_text() has them. Where lines would be
/// longer than `width` (0: no limit) and the last column is one of words, that column is folded at its blanks.
void write_text(std::ostream& out, const Table& table, bool header, std::size_t width = 0);

/// The length of the longest line of that text, without folding and with a header.
[[nodiscard]] std::size_t text_width(const Table& table);

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

/// A value for eyes: as few digits as digits.hpp says, NULL is `-`.
std::string short_text(const Value& value);

}  // namespace rouleau::campaign
