// SPDX-License-Identifier: BSD-3-Clause
// The three ways to write a table.
#include "report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

namespace rouleau::campaign {
namespace {

bool is_number(const Value& value) {
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

/// The number of characters that a terminal shows: UTF-8 continuation bytes take no place.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return to_the_right ? blanks + text : text + blanks;
}

nlohmann::ordered_json json_of(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

}  // namespace

std::string exact_text(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return "";
}

std::string short_text(const Value& value) {
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{:.6g}", *real);
  if (std::holds_alternative<std::monostate>(value)) return "-";
  return exact_text(value);
}

void write_text(std::ostream& out, const Table& table, bool header) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> width(columns, 0);
  std::vector<bool> numeric(columns, false);
  for (std::size_t c = 0; c < columns; ++c) {
    if (header) width[c] = width_of(table.columns[c]);
    for (const auto& row : table.rows) {
      width[c] = std::max(width[c], width_of(short_text(row[c])));
      numeric[c] = numeric[c] || is_number(row[c]);
    }
  }
  const auto write_line = [&](auto&& text_of) {
    std::string line;
    for (std::size_t c = 0; c < columns; ++c) line += (c == 0 ? "" : "  ") + padded(text_of(c), width[c], numeric[c]);
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  };
  if (header) write_line([&](std::size_t c) { return table.columns[c]; });
  for (const auto& row : table.rows) write_line([&](std::size_t c) { return short_text(row[c]); });
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
