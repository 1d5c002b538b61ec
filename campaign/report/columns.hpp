// SPDX-License-Identifier: BSD-3-Clause
// The names that a query may use, and what each is in SQL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "store/store.hpp"

namespace rouleau::campaign {

enum class ColumnType { number, text };

/// A column of the table of points and results.
struct Column {
  std::string name;  ///< full: `d_mean_um`, `fluid.lambda`
  std::string sql;   ///< an expression over `p` (v_points) and `r` (results); empty for a run parameter
  ColumnType type = ColumnType::text;
  std::string description;
  std::string error = {};  ///< name of the column that holds its standard error; mostly none
};

/// The values of an SQL statement in the order of their numbers.
class BoundValues {
 public:
  /// Adds a value; returns its placeholder, `?3`.
  std::string add(Value value);
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

 private:
  std::vector<Value> values_;
};

/// All columns of a campaign: the fixed ones and one for every run parameter of its points.
class Columns {
 public:
  explicit Columns(const Store& store);

  [[nodiscard]] const std::vector<Column>& all() const& { return columns_; }
  [[nodiscard]] const std::vector<std::string>& swept() const& { return swept_; }  ///< full names, in the study's order

  /// The column of that full name, or of that last part (`lambda`) when only one run parameter has it.
  /// throws  Error (usage) saying what `name` could have meant
  [[nodiscard]] const Column& find(std::string_view name) const;

  /// The shortest name that find() resolves to the column.
  [[nodiscard]] std::string short_name(const Column& column) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::string> swept_;
};

/// The words that a column of few words can hold; empty: any.
[[nodiscard]] std::vector<std::string> words_of(const Column& column);

/// The SQL expression of a column; what it needs is added to `values`.
std::string expression_of(const Column& column, BoundValues& values);

}  // namespace rouleau::campaign
