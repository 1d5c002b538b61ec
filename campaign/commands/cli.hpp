// SPDX-License-Identifier: BSD-3-Clause
// The command line of `rouleau`: what a verb is, what it is handed, and the streams it writes to.
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/error.hpp"

namespace rouleau::campaign {

/// How results are written to stdout: for eyes, for spreadsheets (RFC 4180), for programs (with schema_version).
enum class Format { table, csv, json };

/// Where a verb writes: results to `out`, messages and progress to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool out_is_terminal = false;
  bool err_is_terminal = false;
  bool colour = false;   ///< colour allowed on `out`
  int columns = 80;      ///< width of the terminal; of no meaning when `out` is none
  bool redraws = false;  ///< `out` is a terminal that can be drawn over
};

/// What the words that follow a verb mean.
enum class Words {
  campaign,  ///< at most one: the campaign's directory, another way to write --dir
  points,    ///< points: a key, a unique beginning of one, #ordinal, or name=value
  free,      ///< the verb's own business
};

/// A parsed command line, as handed to a verb.
struct CommandLine {
  boost::program_options::variables_map values;  ///< the verb's own options
  std::vector<std::string> words;                ///< positional arguments (empty for Words::campaign)
  std::filesystem::path directory = ".";         ///< the campaign's directory: --dir, or the current one
  Format format = Format::table;                 ///< --format
  bool header = true;                            ///< unless --no-header
  bool quiet = false;                            ///< --quiet: no messages but errors
  Streams& io;

  /// Whether a switch (`bool_switch`) was given.
  [[nodiscard]] bool is_set(const char* name) const { return values.count(name) != 0 && values[name].as<bool>(); }
  /// Whether an option with a value was given or has a default.
  [[nodiscard]] bool has(const char* name) const { return values.count(name) != 0; }
  template <class T>
  [[nodiscard]] const T& get(const char* name) const {
    return values[name].as<T>();
  }
};

/// One verb of the command line. Each lives in a file of its own, named like the verb.
struct Verb {
  const char* name;
  const char* summary;   ///< one line for `rouleau --help`
  const char* synopsis;  ///< what follows `rouleau <name> `
  const char* examples;  ///< lines of "rouleau ..." that lead the verb's --help
  const char* notes;     ///< further explanation, or ""
  Words words;
  bool has_format;                                                         ///< whether --format and --no-header exist
  void (*describe)(boost::program_options::options_description& options);  ///< adds the verb's own options; may be null
  int (*run)(const CommandLine& line);                                     ///< returns the exit code
};

/// Parses and runs a command line; prints every error as one line on `io.err`.
/// `arguments` do not hold the program's name.   returns the exit code
int run_command_line(std::span<const Verb* const> verbs, const std::vector<std::string>& arguments, Streams& io);

}  // namespace rouleau::campaign
