// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

namespace rouleau::validation {
namespace {

constexpr std::size_t columns = 8;
using Row = std::array<std::string, columns>;

const char* verdict(const Finding& finding) { return !finding.expected ? "–" : finding.has_passed() ? "pass" : "FAIL"; }

Row row_of(const Finding& finding) {
  const bool is_check = finding.expected.has_value();
  return {finding.case_name,
          finding.quantity,
          fmt::format("{:.7g}", finding.ours),
          is_check ? finding.expected->text : "–",
          is_check ? fmt::format("{:.2g}", finding.ours - finding.expected->reference) : "–",
          verdict(finding),
          fmt::format("{:.1f}", finding.time_s),
          finding.source + (finding.source.empty() || finding.note.empty() ? "" : "; ") + finding.note};
}

/// Characters that a terminal shows: the continuation bytes of UTF-8 take no place.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

}  // namespace

std::string line_of(const Finding& finding) {
  const Row row = row_of(finding);
  return fmt::format("{:<5} {}: {} ({}){}{}", row[5], row[1], row[2], row[3], finding.note.empty() ? "" : "; ",
                     finding.note);
}

std::string table_of(std::span<const Finding> findings) {
  std::vector<Row> rows{
      {"case", "quantity", "ours", "reference, tolerance", "difference", "verdict", "time s", "source; note"},
      {"---", "---", "---", "---", "---", "---", "---", "---"}};
  std::size_t checks = 0, held = 0;
  for (const Finding& finding : findings) {
    rows.push_back(row_of(finding));
    checks += finding.expected.has_value();
    held += finding.expected && finding.has_passed();
  }
  std::array<std::size_t, columns> widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c + 1 < columns; ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  std::string table;
  for (const Row& row : rows) {
    table += "|";
    for (std::size_t c = 0; c < columns; ++c)
      table += " " + row[c] + std::string(std::max(widths[c], width_of(row[c])) - width_of(row[c]), ' ') + " |";
    table += "\n";
  }
  return table + fmt::format("\n{} of {} checks hold\n", held, checks);
}

std::string json_of(std::span<const Finding> findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    if (!finding.expected) continue;
    const Expected& expected = *finding.expected;
    list.push_back({{"case", finding.case_name},
                    {"quantity", finding.quantity},
                    {"ours", finding.ours},
                    {"reference", expected.reference},
                    {"tolerance", expected.tolerance},
                    {"expected", expected.text},
                    {"difference", finding.ours - expected.reference},
                    {"source", finding.source},
                    {"pass", finding.has_passed()},
                    {"time_s", finding.time_s},
                    {"note", finding.note}});
  }
  return list.dump(1) + "\n";
}

}  // namespace rouleau::validation
