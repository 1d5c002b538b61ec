// SPDX-License-Identifier: BSD-3-Clause
#include "run/ini.hpp"

#include <algorithm>
#include <boost/program_options/parsers.hpp>
#include <map>
#include <sstream>

#include "base/error.hpp"

namespace rouleau {
namespace {

namespace po = boost::program_options;

constexpr std::size_t longest_line = 1000;  // bytes; keeps messages that quote it readable

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t") - begin + 1));
}

// Length of the UTF-8 sequence at the front of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 0;
  if (length == 0 || byte(0) >= 0xF5 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates, and code points beyond the last one.
  if ((byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
      (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F))
    return 0;
  return length;
}

// Messages end up in JSON, so what is no text must not get further than this.
void refuse_what_is_no_text(std::string_view line, const std::string& where) {
  for (std::size_t i = 0; i < line.size();) {
    const auto byte = static_cast<unsigned char>(line[i]);
    const std::size_t length = utf8_length(line.substr(i));
    if (length == 0 || (byte < 0x20 && byte != '\t') || byte == 0x7f)
      fail(Exit::bad_input, "{}: byte 0x{:02x} in column {} is not text; write the file as plain UTF-8", where,
           static_cast<unsigned>(byte), i + 1);
    i += length;
  }
}

// One entry at a time goes through Boost's parser, so that every entry knows its line.
IniEntry parse_entry(const std::string& line, const std::string& section, int number, const std::string& where) {
  std::istringstream stream(line);
  po::options_description none;
  std::vector<po::option> options;
  try {
    options = po::parse_config_file(stream, none, true).options;
  } catch (const po::error&) {
    options.clear();
  }
  if (options.size() != 1 || options[0].string_key.empty())
    fail(Exit::bad_input, "{}: `{}` is neither a [section] nor `name = value` nor a # comment", where, line);
  std::string value = options[0].value.empty() ? std::string() : options[0].value[0];
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
    value = trimmed(value.substr(1, value.size() - 2));
  if (value.empty())
    fail(Exit::bad_input, "{}: {} has no value; give one, or remove the line to use the default", where,
         options[0].string_key);
  return {section, options[0].string_key, value, number};
}

std::string section_name(const std::string& line, const std::string& where) {
  if (line.back() != ']') fail(Exit::bad_input, "{}: `{}` is not a section; write [name]", where, line);
  std::string name = trimmed(std::string_view(line).substr(1, line.size() - 2));
  if (name.empty()) fail(Exit::bad_input, "{}: a section needs a name: [name]", where);
  return name;
}

}  // namespace

Ini read_ini(std::string_view text, const std::string& source) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    fail(Exit::bad_input, "{}:1: the file is UTF-16; save it as UTF-8", source);
  Ini ini;
  std::map<std::string, int> lines;  // of sections (`[name`) and of entries (`section.name`)
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view raw = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (raw.ends_with('\r')) raw.remove_suffix(1);
    const std::string where = fmt::format("{}:{}", source, ++ini.lines);
    if (raw.size() > longest_line)
      fail(Exit::bad_input, "{}: the line has {} bytes; at most {} are allowed", where, raw.size(), longest_line);
    refuse_what_is_no_text(raw, where);
    const std::string line = trimmed(raw.substr(0, raw.find('#')));
    if (line.empty()) continue;
    if (line.front() == '[') {
      const std::string name = section_name(line, where);
      const auto [first, is_new] = lines.emplace("[" + name, ini.lines);
      if (!is_new)
        fail(Exit::bad_input, "{}: section [{}] was begun in line {} already; join the two", where, name,
             first->second);
      ini.sections.push_back({name, ini.lines});
      continue;
    }
    if (ini.sections.empty())
      fail(Exit::bad_input, "{}: `{}` stands before the first [section]; put it into one", where, line);
    IniEntry entry = parse_entry(line, ini.sections.back().name, ini.lines, where);
    const auto [first, is_new] = lines.emplace(entry.section + "." + entry.name, ini.lines);
    if (!is_new)
      fail(Exit::bad_input, "{}: {} was given in line {} already; keep one", where, entry.name, first->second);
    ini.entries.push_back(std::move(entry));
  }
  return ini;
}

}  // namespace rouleau
