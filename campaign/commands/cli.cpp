// SPDX-License-Identifier: BSD-3-Clause
// Parsing command lines, printing help, turning errors into one line and an exit code.
#include "commands/cli.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <filesystem>
#include <ostream>

#include "commands/version.hpp"
#include "study/nearest.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

const char* words_option = "words";

constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0 ok   1 failed   2 wrong usage or study file   3 nothing found   4 some points failed\n"
    "  5 locked by another live process   6 engine does not answer   7 damage found   130 interrupted\n";

[[noreturn]] void usage_error(const std::string& message, const std::string& help_of) {
  fail(Exit::usage, "{} `rouleau {}--help` explains.", message, help_of);
}

po::options_description common_options(const Verb& verb) {
  po::options_description options("Options of every verb");
  auto add = options.add_options();
  if (verb.words != Words::free) {
    add("dir,C", po::value<std::string>()->value_name("DIR"), "the campaign's directory (default: the current one)");
  }
  if (verb.has_format) {
    add("format", po::value<std::string>()->value_name("F")->default_value("table"), "table, csv or json");
    add("no-header", po::bool_switch(), "no line of column names");
  }
  add("quiet,q", po::bool_switch(), "no messages but errors");
  add("help,h", po::bool_switch(), "this text");
  return options;
}

void print_overview(std::span<const Verb* const> verbs, std::ostream& out) {
  out << "rouleau: campaigns of red-blood-cell simulations, from a study file to a phase table\n\n"
         "Examples:\n"
         "  rouleau init study.ini my-campaign     make a campaign from a study file\n"
         "  rouleau run my-campaign                run it; again after any interruption or crash\n"
         "  rouleau status my-campaign             how far is it?\n"
         "  rouleau query -C my-campaign           the phase table so far\n\n"
         "Verbs (rouleau VERB --help tells more):\n";
  for (const Verb* verb : verbs) out << fmt::format("  {:<9} {}\n", verb->name, verb->summary);
  out << "\n  --help     this text\n  --version  versions of rouleau and of what it is built with\n\n" << exit_codes;
}

void print_help(const Verb& verb, std::ostream& out) {
  out << "rouleau " << verb.name << ": " << verb.summary << "\n\nExamples:\n" << verb.examples;
  out << "\nUsage: rouleau " << verb.name << ' ' << verb.synopsis << "\n\n";
  if (*verb.notes != '\0') out << verb.notes << "\n";
  po::options_description own("Options");
  if (verb.describe != nullptr) {
    verb.describe(own);
    out << own << "\n";
  }
  out << common_options(verb);
  if (verb.words == Words::points) {
    out << "\nA POINT is a key, the unique beginning of one, #ordinal, or name=value such as lambda=5.\n";
  }
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

po::variables_map parse(const Verb& verb, const po::options_description& options,
                        const std::vector<std::string>& arguments) {
  po::positional_options_description positional;
  positional.add(words_option, -1);
  const std::string help_of = std::string(verb.name) + ' ';
  po::variables_map values;
  try {
    // Abbreviated options would change their meaning when a new one is added.
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments).options(options).positional(positional).style(style).run(), values);
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
  po::options_description options;
  if (verb.describe != nullptr) verb.describe(options);
  options.add(common_options(verb));
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
