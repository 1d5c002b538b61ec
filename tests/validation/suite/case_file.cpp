// SPDX-License-Identifier: BSD-3-Clause
#include "case_file.hpp"

#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "run/value_text.hpp"
#include "storage/files.hpp"

namespace rouleau::validation {

CaseFile::CaseFile(const std::filesystem::path& path)
    : name_(path.filename().string()), ini_(read_ini(read_file(posix_file_system(), path), name_)) {}

const IniEntry& CaseFile::find(const std::string& section, const std::string& name) {
  for (const IniEntry& entry : ini_.entries)
    if (entry.section == section && entry.name == name) {
      used_lines_.insert(entry.line);
      return entry;
    }
  fail(Exit::bad_input, "{}: [{}] {} is missing; the case needs it", name_, section, name);
}

double CaseFile::parse(const IniEntry& entry, const std::string& text) const {
  const auto begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  const std::string word = begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
  try {
    return parse_real(word);
  } catch (const std::invalid_argument& error) {
    fail(Exit::bad_input, "{}:{}: {} = {} {}", name_, entry.line, entry.name, word, error.what());
  }
}

double CaseFile::number(const std::string& section, const std::string& name) {
  const IniEntry& entry = find(section, name);
  return parse(entry, entry.value);
}

int CaseFile::integer(const std::string& section, const std::string& name) {
  const IniEntry& entry = find(section, name);
  const double value = parse(entry, entry.value);
  if (value != std::floor(value) || std::abs(value) > 1e9)
    fail(Exit::bad_input, "{}:{}: {} = {} is no whole number below 1e9", name_, entry.line, name, entry.value);
  return static_cast<int>(value);
}

std::vector<double> CaseFile::numbers(const std::string& section, const std::string& name) {
  const IniEntry& entry = find(section, name);
  std::vector<double> values;
  for (std::size_t begin = 0; begin <= entry.value.size();) {
    const std::size_t comma = std::min(entry.value.find(',', begin), entry.value.size());
    values.push_back(parse(entry, entry.value.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  return values;
}

void CaseFile::require_all_used() const {
  for (const IniEntry& entry : ini_.entries)
    if (!used_lines_.contains(entry.line))
      fail(Exit::bad_input, "{}:{}: [{}] {} is not known to this case; remove it", name_, entry.line, entry.section,
           entry.name);
}

}  // namespace rouleau::validation
