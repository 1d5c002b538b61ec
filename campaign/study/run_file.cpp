// SPDX-License-Identifier: BSD-3-Clause
// Writing run files and finding the files they name.
#include "study/run_file.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

std::string section_of(const std::string& name) { return name.substr(0, name.rfind('.')); }
std::string entry_of(const std::string& name) { return name.substr(name.rfind('.') + 1); }

std::string written(const Entry& entry, const NamedFiles& files, FileNames names) {
  if (!names_a_file(entry.name)) return entry.value;
  const NamedFile& file = files.at(entry.value);
  return names == FileNames::source ? file.source.string() : "../../" + file.stored;
}

void find_named_file(NamedFiles& files, const Study& study, const std::string& value, int line) {
  if (files.contains(value)) return;
  const std::filesystem::path beside = std::filesystem::absolute(study.source).parent_path();
  const std::filesystem::path source = (beside / value).lexically_normal();
  if (!std::filesystem::is_regular_file(source)) {
    fail(Exit::usage, "{}:{}: the file `{}` is not there (looked for {}). Paths count from the study file's directory.",
         study.file_name(), line, value, source.string());
  }
  const std::string content = read_whole_file(source).value_or("");
  std::string stem = source.stem().string();
  const std::string digest = digest_of(content).substr(0, digits_in_name);
  // A copy that we named ourselves keeps its name, so that a campaign's own study.ini can be read again.
  if (const std::string ending = "-" + digest; stem.ends_with(ending)) stem.resize(stem.size() - ending.size());
  files[value] = {source, "files/" + stem + "-" + digest + source.extension().string()};
}

}  // namespace

bool names_a_file(const std::string& parameter) { return parameter.ends_with("_file"); }

NamedFiles find_named_files(const Study& study) {
  NamedFiles files;
  for (const Entry& entry : study.fixed) {
    if (names_a_file(entry.name)) find_named_file(files, study, entry.value, entry.line);
  }
  for (const Axis& axis : study.axes) {
    if (!names_a_file(axis.name)) continue;
    for (const std::string& value : axis.values) find_named_file(files, study, value, axis.line);
  }
  return files;
}

RunFile run_file_of(const Combination& combination, const NamedFiles& files, FileNames names,
                    const std::string& title) {
  std::vector<std::string> sections;
  for (const Entry& entry : combination.entries) {
    const std::string section = section_of(entry.name);
    if (std::find(sections.begin(), sections.end(), section) == sections.end()) sections.push_back(section);
  }
  RunFile run_file;
  const auto add = [&](const std::string& line, int study_line) {
    run_file.text += line + '\n';
    run_file.study_lines.push_back(study_line);
  };
  add("# " + title, 0);
  for (const std::string& section : sections) {
    add("", 0);
    add("[" + section + "]", 0);
    for (const Entry& entry : combination.entries) {
      if (section_of(entry.name) == section)
        add(entry_of(entry.name) + " = " + written(entry, files, names), entry.line);
    }
  }
  return run_file;
}

std::string to_study_lines(const std::string& message, const RunFile& run_file, const std::string& study_name) {
  const std::string name = "run.ini";
  std::string result;
  std::size_t done = 0;  // of the message
  for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at + 1)) {
    std::size_t end = at + name.size();
    if (end >= message.size() || message[end] != ':') continue;
    std::size_t line = 0;
    const auto [digits_end, error] = std::from_chars(message.data() + end + 1, message.data() + message.size(), line);
    const bool has_line = error == std::errc() && digits_end != message.data() + message.size() && *digits_end == ':';
    if (has_line) end = static_cast<std::size_t>(digits_end - message.data());
    const int study_line =
        has_line && line >= 1 && line <= run_file.study_lines.size() ? run_file.study_lines[line - 1] : 0;

    const bool has_folder = at > done && message[at - 1] == '/';
    const std::size_t begin = has_folder ? std::max(done, message.find_last_of(" \t\n", at) + 1) : at;
    result.append(message, done, begin - done);
    result += study_line > 0 ? study_name + ':' + std::to_string(study_line) : study_name;
    done = end;
  }
  return result.append(message, done);
}

std::string with_stored_files(const Study& study, const NamedFiles& files) {
  std::map<int, std::string> replaced;  // by line
  for (const Entry& entry : study.fixed) {
    if (names_a_file(entry.name)) replaced[entry.line] = entry_of(entry.name) + " = " + files.at(entry.value).stored;
  }
  for (const Axis& axis : study.axes) {
    if (!names_a_file(axis.name)) continue;
    std::string values;
    for (const std::string& value : axis.values) values += (values.empty() ? "" : ", ") + files.at(value).stored;
    replaced[axis.line] = axis.name + " = " + values;
  }
  if (replaced.empty()) return study.text;
  std::istringstream lines(study.text);
  std::string result, line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const auto found = replaced.find(number);
    result += (found == replaced.end() ? line : found->second) + '\n';
  }
  return result;
}

}  // namespace rouleau::campaign
