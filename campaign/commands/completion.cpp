// SPDX-License-Identifier: BSD-3-Clause
// Where the last word stands decides what it may be: a verb, an option, an option's value, or a verb's word.
#include "commands/completion.hpp"

#include <algorithm>
#include <sstream>

#include "commands/help.hpp"
#include "commands/manual.hpp"
#include "commands/option_list.hpp"
#include "report/columns.hpp"
#include "store/store.hpp"
#include "study/ini.hpp"
#include "study/numbers.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

namespace {

using Candidates = std::vector<Candidate>;

/// Behind the last comma, and with what stands before it in front of each.
template <class List>
Candidates after_comma(const std::string& word, List list) {
  const std::size_t begin = word.rfind(',') + 1;  // 0 without a comma
  Candidates found = list(word.substr(begin));
  for (Candidate& candidate : found) candidate.text.insert(0, word, 0, begin);
  return found;
}

std::string swept_text(const std::vector<ParameterRow>& parameters) {
  std::string text;
  for (const ParameterRow& row : parameters)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", row.name, row.text);
  return text;
}

/// `name=` of the swept parameters; behind it their values.
Candidates swept_values(const Store& store, const Columns& columns, const std::string& word) {
  Candidates found;
  const std::map<std::string, std::vector<ParameterRow>> swept = store.swept_parameters();
  for (const std::string& full_name : columns.swept()) {
    const std::string name = columns.short_name(columns.find(full_name));
    if (!word.starts_with(name + "=")) {
      found.push_back({name + "=", "points with this value"});
      continue;
    }
    std::vector<std::string> values;
    for (const auto& [key, parameters] : swept)
      for (const ParameterRow& row : parameters)
        if (row.name == full_name) values.push_back(row.text);
    std::sort(values.begin(), values.end(), [](const std::string& a, const std::string& b) {
      return std::pair(parse_number(a), a) < std::pair(parse_number(b), b);  // by size, where they are numbers
    });
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const std::string& value : values) found.push_back({name + "=" + value, ""});
  }
  return found;
}

Candidates points(const Store& store, const std::string& word) {
  const Columns columns(store);
  Candidates found = after_comma(word, [&](const std::string& part) { return swept_values(store, columns, part); });
  const std::map<std::string, std::vector<ParameterRow>> swept = store.swept_parameters();
  for (const PointRow& point : store.points()) {
    const auto values = swept.find(point.key);
    const std::string text = values == swept.end() ? "" : swept_text(values->second);
    found.push_back({fmt::format("#{}", point.ordinal), fmt::format("{} {}", text, word_of(point.state))});
  }
  return found;
}

Candidates column_names(const Store& store, const std::string& sign) {
  const Columns columns(store);
  Candidates found;
  for (const Column& column : columns.all()) found.push_back({sign + columns.short_name(column), column.description});
  return found;
}

/// The beginning of a condition: `name=`, behind it the words that the column can hold.
Candidates conditions(const Store& store, const std::string& word) {
  const Columns columns(store);
  Candidates found = swept_values(store, columns, word);
  for (const Column& column : columns.all()) {
    const std::string begin = columns.short_name(column) + "=";
    if (!word.starts_with(begin))
      found.push_back({begin, column.description});
    else
      for (const std::string& value : words_of(column)) found.push_back({begin + value, ""});
  }
  return found;
}

/// The candidates of a list that needs the campaign; none if there is no campaign that can be read, as no error may be
/// shown in the middle of a line that is being written.
template <class List>
Candidates of_campaign(const std::filesystem::path& directory, List list) {
  try {
    return list(Store::open_reader(directory / "campaign.db"));
  } catch (const Error&) {
    return {};
  }
}

/// What may stand for a placeholder of the help, such as FILE or csv|json.
Candidates values_of(const std::string& placeholder, const std::filesystem::path& campaign, const std::string& word) {
  Candidates found;
  if (placeholder == "FILE" || placeholder == "STUDY") return {{any_file, ""}};
  if (placeholder == "DIR") return {{any_directory, ""}};
  if (placeholder == "POINT") return of_campaign(campaign, [&](const Store& store) { return points(store, word); });
  if (placeholder == "COND") return of_campaign(campaign, [&](const Store& store) { return conditions(store, word); });
  if (placeholder == "COLUMN,..." || placeholder == "[-]COLUMN,...")
    return of_campaign(campaign, [&](const Store& store) {
      return after_comma(word, [&](const std::string& part) {
        return column_names(store, placeholder.front() == '[' && part.starts_with('-') ? "-" : "");
      });
    });
  if (placeholder == "NAME=VALUE") {
    for (const SettingRow<Analysis>& row : analysis_rows())
      found.push_back({std::string(row.name) + "=", std::string(row.help)});
  } else if (placeholder.find('|') != std::string::npos) {
    for (const std::string& choice : split(placeholder, '|')) found.push_back({choice, ""});
  }
  return found;
}

/// The words that a verb takes, from its synopsis: what stands before the first option.
Candidates words_of_verb(const Verb& verb, const std::filesystem::path& campaign, const std::string& word) {
  std::istringstream synopsis(verb.synopsis);
  Candidates found;
  for (std::string token; synopsis >> token;) {
    std::erase_if(token, [](char c) { return c == '[' || c == ']' || c == '|' || c == '.'; });
    if (token.starts_with('-')) break;
    if (token.empty()) continue;
    const bool is_placeholder = std::all_of(token.begin(), token.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    const Candidates values = is_placeholder ? values_of(token, campaign, word) : Candidates{{token, ""}};
    found.insert(found.end(), values.begin(), values.end());
  }
  return found;
}

/// The line before its last word.
struct Beginning {
  std::filesystem::path campaign = ".";
  const OptionEntry* open = nullptr;  ///< an option whose value is the last word
  int words = 0;                      ///< that are neither options nor their values
};

Beginning read_beginning(const Verb& verb, const std::vector<OptionEntry>& options,
                         std::span<const std::string> words) {
  Beginning line;
  for (const std::string& word : words) {
    if (line.open != nullptr) {
      if (line.open->long_name == "--dir") line.campaign = word;
      line.open = nullptr;
    } else if (word.starts_with("--dir=")) {
      line.campaign = word.substr(6);
    } else if (word.starts_with('-')) {
      for (const OptionEntry& option : options)
        if ((word == option.long_name || word == option.short_name) && !option.is_switch() && !option.value_may_miss)
          line.open = &option;
    } else {
      if (verb.words == Words::campaign) line.campaign = word;
      ++line.words;
    }
  }
  return line;
}

Candidates for_verb(const Verb& verb, std::span<const std::string> words) {
  std::vector<OptionEntry> options = own_options(verb);
  const std::vector<OptionEntry> common = common_options(verb);
  options.insert(options.end(), common.begin(), common.end());
  const std::string& word = words.back();
  const Beginning line = read_beginning(verb, options, words.first(words.size() - 1));
  if (line.open != nullptr) return values_of(line.open->value_name, line.campaign, word);

  Candidates found;
  if (const std::size_t equals = word.find('='); word.starts_with("--") && equals != std::string::npos) {
    const auto option = std::find_if(options.begin(), options.end(), [&](const OptionEntry& candidate) {
      return candidate.long_name == word.substr(0, equals);
    });
    if (option == options.end()) return {};
    found = values_of(option->value_name, line.campaign, word.substr(equals + 1));
    for (Candidate& candidate : found)
      if (!candidate.text.starts_with('<')) candidate.text.insert(0, word, 0, equals + 1);
  } else if (word.starts_with('-')) {
    for (const OptionEntry& option : options) found.push_back({option.long_name, option.meaning});
  } else if (verb.words != Words::campaign || line.words == 0) {
    found = words_of_verb(verb, line.campaign, word);
  }
  return found;
}

Candidates for_program(std::span<const Verb* const> verbs, const std::string& word) {
  Candidates found;
  if (word.starts_with('-'))
    for (const Meaning& option : program_options) found.push_back({option.word, option.meaning});
  else
    for (const Verb* verb : verbs) found.push_back({verb->name, verb->summary});
  return found;
}

}  // namespace

std::vector<Candidate> completions(std::span<const Verb* const> verbs, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Candidates found;
  if (words.size() == 1) found = for_program(verbs, words.front());
  if (words.size() == 2 && words.front() == "--man")
    for (const std::string& page : manual_page_names()) found.push_back({page, ""});
  for (const Verb* verb : verbs)
    if (words.size() > 1 && verb->name == words.front()) found = for_verb(*verb, std::span(words).subspan(1));
  std::erase_if(found, [&](const Candidate& candidate) {
    return !candidate.text.starts_with('<') && !candidate.text.starts_with(words.back());
  });
  return found;
}

}  // namespace rouleau::campaign
