// SPDX-License-Identifier: BSD-3-Clause
// A line scanner for INI text. Boost's own reader is not used here: its errors name no line.
#include "study/ini.hpp"

#include <map>
#include <sstream>

#include "study/error.hpp"

namespace rouleau::campaign {

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

std::vector<IniEntry> parse_ini(const std::string& text, const std::string& file) {
  std::vector<IniEntry> entries;
  std::map<std::string, int> seen;
  std::string section;
  std::istringstream lines(text);
  std::string raw;
  for (int number = 1; std::getline(lines, raw); ++number) {
    const std::string line = trimmed(raw.substr(0, raw.find('#')));
    if (line.empty()) continue;
    if (line.front() == '[') {
      if (line.back() != ']' || line.size() < 3) {
        fail(Exit::usage, "{}:{}: `{}` opens no section. Write [name].", file, number, line);
      }
      section = trimmed(line.substr(1, line.size() - 2));
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) {
      fail(Exit::usage, "{}:{}: `{}` is neither [section] nor name = value. Comments begin with #.", file, number,
           line);
    }
    IniEntry entry{section, trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), number};
    if (entry.name.empty()) fail(Exit::usage, "{}:{}: there is no name in front of `=`.", file, number);
    if (section.empty()) {
      fail(Exit::usage, "{}:{}: `{}` stands before the first section. Put it below one, such as [study].", file, number,
           entry.name);
    }
    if (entry.value.empty()) {
      fail(Exit::usage, "{}:{}: `{}` has no value. Give one, or remove the line.", file, number, entry.name);
    }
    const auto [before, is_new] = seen.emplace(section + '.' + entry.name, number);
    if (!is_new) {
      fail(Exit::usage, "{}:{}: `{}` of [{}] was given in line {} already. Keep one of the two.", file, number,
           entry.name, section, before->second);
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace rouleau::campaign
