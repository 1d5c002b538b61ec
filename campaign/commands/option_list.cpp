// SPDX-License-Identifier: BSD-3-Clause
// From Boost's descriptions of options to their parts.
#include "commands/option_list.hpp"

#include <boost/program_options.hpp>

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

void describe_common(const Verb& verb, po::options_description& options) {
  auto add = options.add_options();
  if (verb.words != Words::free) {
    add("dir,C", po::value<std::string>()->value_name("DIR"), "the campaign's directory (default: the current one)");
  }
  if (verb.has_format) {
    add("format", po::value<std::string>()->value_name("table|csv|json")->default_value("table"),
        "for eyes, for spreadsheets, for programs");
    add("no-header", po::bool_switch(), "no line of column names");
  }
  add("quiet,q", po::bool_switch(), "no messages but errors");
  add("help,h", po::bool_switch(), "this text");
}

OptionEntry entry_of(const po::option_description& option) {
  const po::value_semantic& value = *option.semantic();
  OptionEntry entry;
  entry.long_name = "--" + option.long_name();
  entry.short_name = option.canonical_display_name(po::command_line_style::allow_dash_for_short);
  if (entry.short_name == option.long_name()) entry.short_name.clear();  // it has none
  entry.value_may_miss = value.min_tokens() == 0 && value.max_tokens() > 0;
  entry.meaning = option.description();
  if (value.max_tokens() == 0) return entry;

  // Boost knows a value's name and default only as one text: "S (=300)", "[=SECONDS(=60)]".
  const std::string text = value.name();
  const std::size_t begin = text.starts_with("[=") ? 2 : 0;
  const std::size_t value_default = text.find("(=");
  entry.value_name = text.substr(begin, value_default - begin);
  if (entry.value_name.ends_with(' ')) entry.value_name.pop_back();
  if (value_default != std::string::npos && !entry.value_may_miss)
    entry.default_text = text.substr(value_default + 2, text.rfind(')') - value_default - 2);
  return entry;
}

std::vector<OptionEntry> entries_of(const po::options_description& options) {
  std::vector<OptionEntry> entries;
  for (const auto& option : options.options()) entries.push_back(entry_of(*option));
  return entries;
}

}  // namespace

std::string OptionEntry::usage() const {
  if (is_switch()) return long_name;
  return value_may_miss ? long_name + "[=" + value_name + "]" : long_name + " " + value_name;
}

std::vector<OptionEntry> own_options(const Verb& verb) {
  po::options_description options;
  if (verb.describe != nullptr) verb.describe(options);
  return entries_of(options);
}

std::vector<OptionEntry> common_options(const Verb& verb) {
  po::options_description options;
  describe_common(verb, options);
  return entries_of(options);
}

po::options_description parsed_options(const Verb& verb) {
  po::options_description options;
  if (verb.describe != nullptr) verb.describe(options);
  describe_common(verb, options);
  return options;
}

}  // namespace rouleau::campaign
