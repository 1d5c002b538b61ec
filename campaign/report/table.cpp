// SPDX-License-Identifier: BSD-3-Clause
// The three ways to write a table.
#include "report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "report/digits.hpp"
#include "report/fit_text.hpp"

namespace rouleau::campaign {
namespace {

bool holds_number(const Value& value) {
  return std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value);
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + "\"";
}

/// Narrower than this, a folded column is harder to read than lines that the terminal breaks.
constexpr std::size_t narrowest_fold = 20;

/// Where the columns of a table lie.
struct Layout {
  Layout(const Table& table, bool header) : width(table.columns.size(), 0), is_number(table.columns.size(), false) {
    for (std::size_t c = 0; c < width.size(); ++c) {
      if (header) width[c] = shown_width(table.columns[c]);
      is_number[c] = table.right_aligned.count(c) == 1;
      for (const auto& row : table.rows) {
        width[c] = std::max(width[c], shown_width(short_text(row[c])));
        is_number[c] = is_number[c] || holds_number(row[c]);
      }
      begin_of_last = c == 0 ? 0 : begin_of_last + width[c - 1] + 2;
    }
  }

  std::vector<std::size_t> width;
  std::vector<bool> is_number;
  std::size_t begin_of_last = 0;
};

nlohmann::ordered_json json_of(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

}  // namespace

void cut(Table& table, std::size_t columns) {
  table.columns.resize(columns);
  for (std::vector<Value>& row : table.rows) row.resize(columns);
}

std::string exact_text(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return "";
}

std::string short_text(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return short_number(*real);
  if (std::holds_alternative<std::monostate>(value)) return "-";
  return exact_text(value);
}

void write_text(std::ostream& out, const Table& table, bool header, std::size_t width) {
  const Layout layout(table, header);
  const std::size_t last = table.columns.size() - 1, begin = layout.begin_of_last;
  const bool folds = width >= begin + narrowest_fold && !layout.is_number[last];
  const auto write_line = [&](auto&& text_of) {
    std::string line;
    for (std::size_t c = 0; c < last; ++c) line += filled(text_of(c), layout.width[c], layout.is_number[c]) + "  ";
    const std::string text = filled(text_of(last), layout.width[last], layout.is_number[last]);
    line += folds && begin + shown_width(text_of(last)) > width ? folded(text, width - begin, begin) : text;
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  };
  if (header) write_line([&](std::size_t c) { return table.columns[c]; });
  for (const auto& row : table.rows) write_line([&](std::size_t c) { return short_text(row[c]); });
}

std::size_t text_width(const Table& table) {
  const Layout layout(table, true);
  return layout.begin_of_last + layout.width.back();
}

void write_csv(std::ostream& out, const Table& table, bool header) {
  const auto write_line = [&](auto&& text_of) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) out << (c == 0 ? "" : ",") << quoted(text_of(c));
    out << "\r\n";
  };
  if (header) write_line([&](std::size_t c) { return table.columns[c]; });
  for (const auto& row : table.rows) write_line([&](std::size_t c) { return exact_text(row[c]); });
}

void JsonRows::add(const Table& part) {
  for (const auto& row : part.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t c = 0; c < part.columns.size(); ++c) object[part.columns[c]] = json_of(row[c]);
    if (!begun_)
      out_ << fmt::format("{{\"schema_version\": {}, \"kind\": \"{}\", \"rows\": [\n  ", json_schema_version, kind_);
    else
      out_ << ",\n  ";
    // Bytes that are no UTF-8 (a file name, say) are replaced rather than ending the listing.
    out_ << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    begun_ = true;
  }
}

void JsonRows::end() {
  if (!begun_)
    out_ << fmt::format("{{\"schema_version\": {}, \"kind\": \"{}\", \"rows\": [", json_schema_version, kind_);
  out_ << (begun_ ? "\n]}\n" : "]}\n");
}

void write_json(std::ostream& out, const Table& table) {
  JsonRows rows(out, table.kind);
  rows.add(table);
  rows.end();
}

}  // namespace rouleau::campaign
