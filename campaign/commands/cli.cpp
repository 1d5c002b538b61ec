// SPDX-License-Identifier: BSD-3-Clause
// Parsing command lines, turning errors into one line and an exit code.
#include "commands/cli.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <filesystem>
#include <functional>
#include <ostream>

#include "commands/completion.hpp"
#include "commands/help.hpp"
#include "commands/manual.hpp"
#include "commands/option_list.hpp"
#include "commands/version.hpp"
#include "study/nearest.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

const char* words_option = "words";

[[noreturn]] void usage_error(const std::string& message, const std::string& help_of) {
  fail(Exit::usage, "{} `rouleau {}--help` explains.", message, help_of);
}

std::vector<std::string> option_names(const po::options_description& options) {
  std::vector<std::string> names;
  for (const auto& option : options.options()) names.push_back(option->long_name());
  std::erase(names, words_option);
  return names;
}

Format format_of(const std::string& word) {
  if (word == "table") return Format::table;
  if (word == "csv") return Format::csv;
  if (word == "json") return Format::json;
  const std::vector<std::string> formats = {"table", "csv", "json"};
  fail(Exit::usage, "--format {} is not known; there are table, csv and json.{}", word, did_you_mean(word, formats));
}

/// Puts options whose value is optional behind all words: only what is joined by `=` is such an option's value, so that
/// `--watch my-campaign` names a campaign.
std::vector<std::string> with_optional_values_last(const po::options_description& options,
                                                   std::vector<std::string> arguments) {
  const auto has_optional_value = [&](const std::string& word) {
    const po::option_description* option =
        word.starts_with("--") ? options.find_nothrow(word.substr(2), false) : nullptr;
    return option != nullptr && option->semantic()->min_tokens() == 0 && option->semantic()->max_tokens() == 1;
  };
  std::stable_partition(arguments.begin(), std::find(arguments.begin(), arguments.end(), "--"),
                        std::not_fn(has_optional_value));
  return arguments;
}

po::variables_map parse(const Verb& verb, const po::options_description& options,
                        const std::vector<std::string>& arguments) {
  po::positional_options_description positional;
  positional.add(words_option, -1);
  const std::string help_of = std::string(verb.name) + ' ';
  po::variables_map values;
  try {
    // Abbreviated options would change their meaning when a new one is added.
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(with_optional_values_last(options, arguments))
                  .options(options)
                  .positional(positional)
                  .style(style)
                  .run(),
              values);
    po::notify(values);
  } catch (const po::unknown_option& error) {
    std::string name = error.get_option_name();
    name.erase(0, name.find_first_not_of('-'));
    std::string suggestion = nearest(name, option_names(options));
    if (!suggestion.empty()) suggestion = " Did you mean `--" + suggestion + "`?";
    usage_error("rouleau " + std::string(verb.name) + ": unknown option " + error.get_option_name() + "." + suggestion,
                help_of);
  } catch (const po::error& error) {
    usage_error("rouleau " + std::string(verb.name) + ": " + error.what() + ".", help_of);
  }
  return values;
}

/// The campaign's directory, named by --dir or as the only word.
void take_directory(const Verb& verb, CommandLine& line) {
  if (line.values.count("dir") != 0) line.directory = line.get<std::string>("dir");
  if (verb.words != Words::campaign) return;
  if (line.words.size() > 1) {
    usage_error(fmt::format("rouleau {}: `{}` is one word too many; one directory is taken.", verb.name, line.words[1]),
                std::string(verb.name) + ' ');
  }
  if (line.words.empty()) return;
  if (line.values.count("dir") != 0) {
    usage_error(
        fmt::format("rouleau {}: the directory is given twice, as `{}` and by --dir.", verb.name, line.words[0]),
        std::string(verb.name) + ' ');
  }
  line.directory = line.words.front();
  line.words.clear();
}

int run_verb(const Verb& verb, const std::vector<std::string>& arguments, Streams& io) {
  po::options_description options = parsed_options(verb);
  options.add_options()(words_option, po::value<std::vector<std::string>>());

  const auto is_help = [](const std::string& word) { return word == "--help" || word == "-h"; };
  if (std::any_of(arguments.begin(), arguments.end(), is_help)) {
    print_help(verb, io.out);
    return static_cast<int>(Exit::ok);
  }
  CommandLine line{.values = parse(verb, options, arguments), .words = {}, .io = io};
  if (line.values.count(words_option) != 0) line.words = line.get<std::vector<std::string>>(words_option);
  take_directory(verb, line);
  if (verb.has_format) {
    line.format = format_of(line.get<std::string>("format"));
    line.header = !line.is_set("no-header");
  }
  line.quiet = line.is_set("quiet");
  return verb.run(line);
}

int dispatch(std::span<const Verb* const> verbs, const std::vector<std::string>& arguments, Streams& io) {
  const std::string first = arguments.empty() ? "--help" : arguments.front();
  if (first == "--version") {
    io.out << version_text();
    return static_cast<int>(Exit::ok);
  }
  if (first == "--man") {
    if (arguments.size() > 2) usage_error("rouleau --man: one page is printed at a time.", "");
    io.out << manual_page(verbs, arguments.size() == 2 ? arguments[1] : "rouleau");
    return static_cast<int>(Exit::ok);
  }
  if (first == complete_option) {
    for (const Candidate& candidate : completions(verbs, {arguments.begin() + 1, arguments.end()}))
      io.out << candidate.text << '\t' << candidate.meaning << '\n';
    return static_cast<int>(Exit::ok);
  }
  if (first == "--help" || first == "-h" || first == "help") {
    print_overview(verbs, arguments.empty() ? io.err : io.out);
    return static_cast<int>(arguments.empty() ? Exit::usage : Exit::ok);
  }
  std::vector<std::string> names;
  for (const Verb* verb : verbs) {
    if (verb->name == first) return run_verb(*verb, {arguments.begin() + 1, arguments.end()}, io);
    names.emplace_back(verb->name);
  }
  usage_error(fmt::format("rouleau: there is no verb `{}`.{}", first, did_you_mean(first, names)), "");
}

}  // namespace

int run_command_line(std::span<const Verb* const> verbs, const std::vector<std::string>& arguments, Streams& io) {
  try {
    return dispatch(verbs, arguments, io);
  } catch (const Error& error) {
    io.err << error.what() << std::endl;
    return static_cast<int>(error.code());
  } catch (const std::filesystem::filesystem_error& error) {
    io.err << error.path1().string() << ": " << error.code().message()
           << ". See that the disk is sound, has room and is yours to write; then do the same again." << std::endl;
    return static_cast<int>(Exit::failed);
  } catch (const std::exception& error) {
    io.err << "rouleau: " << error.what() << std::endl;
    return static_cast<int>(Exit::failed);
  }
}

}  // namespace rouleau::campaign
