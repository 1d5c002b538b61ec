// SPDX-License-Identifier: BSD-3-Clause
#include "run/completion.hpp"

#include <fmt/format.h>

#include <sstream>

#include "run/command_table.hpp"

namespace rouleau {

std::string completions(const std::vector<std::string>& words) {
  if (words.empty()) return "";
  std::string word = words.back(), before = words.size() > 1 ? words[words.size() - 2] : "", lead;
  if (const auto equals = word.find('='); word.starts_with("--") && equals != std::string::npos) {
    before = word.substr(0, equals);
    lead = word.substr(0, equals + 1);
  }
  std::string found;
  const auto offer = [&](const std::string& text, const std::string& meaning) {
    if (text.starts_with(word)) found += fmt::format("{}\t{}\n", text, meaning);
  };

  const std::vector<OptionEntry> options = option_entries();
  for (const OptionEntry& option : options) {
    if (option.name != before || option.value_name.empty()) continue;
    std::istringstream choices(option.value_name.find('|') == std::string::npos ? "" : option.value_name);
    for (std::string choice; std::getline(choices, choice, '|');) offer(lead + choice, "");
    return found;
  }
  if (word.starts_with('-')) {
    for (const OptionEntry& option : options) offer(option.name, option.meaning);
    return found;
  }
  if (words.size() == 1)
    for (const Question& question : questions) offer(question.word, question.meaning);
  return found + "<files>\t\n";
}

}  // namespace rouleau
